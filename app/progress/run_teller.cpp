#include "app/progress/run_teller.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

namespace tw::app {
namespace {

constexpr double rows_of_run = 2000;
constexpr std::array components{"fx", "fy", "fz", "my"};

const Table* forces_of(const RunRecord& record) {
    const auto found = record.tables.find("forces");
    return found == record.tables.end() || !found->second.find("fx") ? nullptr : &found->second;
}

}  // namespace

void ForcesSoFar::Sum::add(double v, double seconds) {
    if (std::isfinite(v) && seconds > 0) value += v * seconds, time += seconds;
}

void ForcesSoFar::begin(const Table& forces) {
    told_.clear();
    std::string head = "time [s]";
    for (const char* name : components)
        if (const Column* c = forces.find(name)) {
            told_.push_back({name, c->unit});
            head += fmt::format(",{} [{}]", name, c->unit);
        }
    row_.assign(told_.size(), {}), all_.assign(told_.size(), {});
    read_ = 0, last_ = 0, next_row_ = 0;
    replace_quietly(file_, head + "\n");
}

void ForcesSoFar::take(const RunRecord& record, double duration) {
    const Table* const table = forces_of(record);
    if (!table) return;
    const bool other_rows = read_ > table->time.size() || (read_ > 0 && table->time[read_ - 1] != last_);
    if (told_.empty() || other_rows) begin(*table);
    std::vector<const Column*> columns;
    for (const ForceTold& f : told_) columns.push_back(table->find(f.name));
    std::string rows;
    for (; read_ < table->time.size(); ++read_) {
        const double time = table->time[read_], seconds = time - last_;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const double v = columns[c]->values[read_];
            row_[c].add(v, seconds);
            if (time > mean_from_) all_[c].add(v, std::min(seconds, time - mean_from_));
            if (std::isfinite(v)) told_[c].now = v;
        }
        last_ = time;
        if (time < next_row_) continue;
        rows += fmt::format("{:.9g}", time);
        for (Sum& sum : row_) {
            rows += std::isfinite(sum.mean()) ? fmt::format(",{:.7g}", sum.mean()) : ",";
            sum = {};
        }
        rows += "\n";
        const double step = duration / rows_of_run;
        next_row_ = (std::floor(time / step) + 1) * step;
    }
    for (std::size_t c = 0; c < columns.size(); ++c) told_[c].mean = all_[c].mean();
    if (!rows.empty()) std::ofstream(file_, std::ios::binary | std::ios::app) << rows;
}

RunTeller::RunTeller(std::filesystem::path folder, std::string method, double mean_from, bool speaks)
    : folder_(std::move(folder)), speaks_(speaks), forces_(folder_ / "forces.csv", mean_from) {
    told_.kind = MemberState::Kind::running;
    told_.method = std::move(method);
    told_.mean_from = mean_from;
    told_.process = ProcessName::own();
}

void RunTeller::progress(const Progress& p) {
    if (!speaks_) return;
    const auto now = std::chrono::steady_clock::now();
    if (begun_ && now - written_ < std::chrono::seconds(1)) return;
    if (!std::exchange(begun_, true)) {
        std::error_code ignored;
        std::filesystem::remove(folder_ / "forces.csv", ignored);  // of an earlier run
    }
    written_ = now;
    told_.time = p.time, told_.duration = p.duration, told_.wall = p.wall, told_.left = p.eta;
    told_.steps = static_cast<double>(p.steps), told_.note = p.note;
    if (p.so_far) {
        forces_.take(*p.so_far, p.duration);
        told_.forces = forces_.told(), told_.checks = p.so_far->validity_checks;
    }
    write();
}

void RunTeller::end(const RunRecord& record) {
    using Kind = MemberState::Kind;
    if (!begun_) return;  // finished before
    told_.kind = record.state == "finished" ? Kind::done : record.state == "stopped" ? Kind::stopped : Kind::failed;
    told_.why = record.reason, told_.note = {}, told_.left = 0;
    told_.steps = record.steps, told_.wall = 0;
    for (const Phase& phase : record.phases) told_.wall += phase.wall;
    forces_.take(record, told_.duration);
    told_.forces = forces_.told(), told_.checks = record.validity_checks;
    if (const auto found = record.tables.find("samples"); found != record.tables.end() && !found->second.time.empty())
        told_.time = found->second.time.back();
    write();
}

void RunTeller::failed(const std::string& why) {
    if (!begun_) return;
    told_.kind = MemberState::Kind::failed, told_.why = why, told_.left = 0;
    write();
}

void RunTeller::write() {
    told_.told = seconds_since_1970();
    replace_quietly(folder_ / progress_file, json_of(told_));
}

}  // namespace tw::app
