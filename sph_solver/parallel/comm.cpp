#include "sph_solver/parallel/comm.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "base/errors.h"
#include "base/in_words.h"
#ifdef TWINWAKE_MPI
#include <mpi.h>
#include <unistd.h>
#endif

namespace tw {

namespace {

/// As how many processes a launcher has started this program; 1 where none did.
int launched_processes() {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) {
        const char* text = std::getenv(name);
        // a batch job's own step is no launcher's
        if (text && (std::string(name) != "SLURM_STEP_NUM_TASKS" || std::getenv("PMIX_RANK"))) return std::atoi(text);
    }
    return 1;
}

}  // namespace

const Comm& Comm::alone() {
    static const Comm one;
    return one;
}

const Comm& Comm::world() {
    static const Comm all = started();
    return all;
}

void Comm::together(const std::function<void()>& part) const {
    if (!many()) return part();
    enum Kind { none, input, run, other };
    struct Failed {
        std::int32_t rank, kind;
    };
    Failed failed{size_, none};
    std::string text;
    const auto note = [&](Kind kind, const std::exception& e) { failed = {rank_, kind}, text = in_words(e); };
    try {
        part();
    } catch (const InputError& e) { note(input, e); } catch (const RunError& e) {
        note(run, e);
    } catch (const std::exception& e) { note(other, e); }
    failed = combined(
        failed, +[](Failed& all, const Failed& own) {
            if (own.rank < all.rank) all = own;
        });
    if (failed.kind == none) return;
    text = broadcast_from(failed.rank, text);
    if (failed.kind == input) throw InputError(text);
    if (failed.kind == run) throw RunError(text);
    throw std::runtime_error(text);
}

#ifdef TWINWAKE_MPI

namespace {

MPI_Comm farewell = MPI_COMM_NULL;  ///< of Comm::end, where no other call can be met

const std::function<void(void*, const void*)>* combining = nullptr;
std::size_t combined_bytes = 0;
void combine_all(void* own, void* all, int* count, MPI_Datatype*) {
    for (int k = 0; k < *count; ++k) {
        const std::size_t at = static_cast<std::size_t>(k) * combined_bytes;
        (*combining)(static_cast<char*>(all) + at, static_cast<const char*>(own) + at);
    }
}

int count_of(std::size_t bytes) {
    if (bytes > 0x7fffffff) throw std::runtime_error("a message between ranks of more than 2 GB: take more ranks");
    return static_cast<int>(bytes);
}

}  // namespace

bool Comm::built_with_mpi() { return true; }

Comm Comm::started() {
    Comm world;
    if (launched_processes() <= 1) return world;
    // Ranks that share a core let each other go on: OpenMPI's own wait for a message keeps it (7.5 ms against 75 us).
    const char* here_text = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
    if (here_text && std::atol(here_text) > sysconf(_SC_NPROCESSORS_ONLN))
        setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &world.rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &world.size_);
    MPI_Comm here;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
    MPI_Comm_rank(here, &world.rank_here_);
    MPI_Comm_size(here, &world.size_here_);
    MPI_Comm_free(&here);
    MPI_Comm_dup(MPI_COMM_WORLD, &farewell);
    return world;
}

void Comm::combine_bytes(void* values, std::size_t each, std::size_t count,
                         const std::function<void(void*, const void*)>& into) const {
    combining = &into;
    combined_bytes = each;
    MPI_Datatype element;
    MPI_Type_contiguous(count_of(each), MPI_BYTE, &element);
    MPI_Type_commit(&element);
    MPI_Op op;
    MPI_Op_create(combine_all, 1, &op);
    MPI_Allreduce(MPI_IN_PLACE, values, count_of(count), element, op, MPI_COMM_WORLD);
    MPI_Op_free(&op);
    MPI_Type_free(&element);
    ++traffic_.collectives;
}

Comm::Bytes Comm::gathered_bytes(std::span<const std::byte> own) const {
    const int n = count_of(own.size());
    std::vector<int> counts(static_cast<std::size_t>(size_)), first(counts.size());
    MPI_Allgather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
    std::size_t all = 0;
    for (std::size_t r = 0; r < counts.size(); ++r) {
        first[r] = count_of(all);
        all += static_cast<std::size_t>(counts[r]);
    }
    Bytes bytes(all);
    MPI_Allgatherv(own.data(), n, MPI_BYTE, bytes.data(), counts.data(), first.data(), MPI_BYTE, MPI_COMM_WORLD);
    traffic_.collectives += 2;
    return bytes;
}

std::vector<Comm::Bytes> Comm::sent_to_first(const Bytes& own) const {
    const std::uint64_t n = own.size();
    std::vector<std::uint64_t> sizes(static_cast<std::size_t>(size_));
    MPI_Gather(&n, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    ++traffic_.collectives;
    std::vector<Bytes> all;
    if (!first()) {
        MPI_Send(own.data(), count_of(own.size()), MPI_BYTE, 0, 1, MPI_COMM_WORLD);
        return all;
    }
    all.push_back(own);
    for (int r = 1; r < size_; ++r) {
        Bytes& bytes = all.emplace_back(sizes[static_cast<std::size_t>(r)]);
        MPI_Recv(bytes.data(), count_of(bytes.size()), MPI_BYTE, r, 1, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
    return all;
}

std::vector<Comm::Bytes> Comm::exchange(const std::vector<Bytes>& to) const {
    const auto n = static_cast<std::size_t>(size_);
    std::vector<std::uint64_t> out(n), in(n);
    for (std::size_t r = 0; r < n; ++r) out[r] = to[r].size();
    MPI_Alltoall(out.data(), 1, MPI_UINT64_T, in.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
    ++traffic_.collectives;
    std::vector<Parcel> sent, got;
    for (std::size_t r = 0; r < n; ++r) {
        if (!to[r].empty()) sent.push_back({static_cast<int>(r), to[r]});
        if (in[r] > 0) got.push_back({static_cast<int>(r), Bytes(in[r])});
    }
    exchange(sent, got);
    std::vector<Bytes> from(n);
    for (Parcel& p : got) from[static_cast<std::size_t>(p.rank)] = std::move(p.bytes);
    return from;
}

void Comm::exchange(std::span<const Parcel> to, std::span<Parcel> from) const {
    std::vector<MPI_Request> requests;
    requests.reserve(to.size() + from.size());
    for (Parcel& p : from)
        MPI_Irecv(p.bytes.data(), count_of(p.bytes.size()), MPI_BYTE, p.rank, 0, MPI_COMM_WORLD,
                  &requests.emplace_back());
    for (const Parcel& p : to) {
        MPI_Isend(p.bytes.data(), count_of(p.bytes.size()), MPI_BYTE, p.rank, 0, MPI_COMM_WORLD,
                  &requests.emplace_back());
        ++traffic_.messages;
        traffic_.bytes += static_cast<std::int64_t>(p.bytes.size());
    }
    ++traffic_.exchanges;
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

std::string Comm::broadcast_from(int rank, std::string text) const {
    if (!many()) return text;
    std::uint64_t n = text.size();
    MPI_Bcast(&n, 1, MPI_UINT64_T, rank, MPI_COMM_WORLD);
    text.resize(n);
    MPI_Bcast(text.data(), count_of(n), MPI_BYTE, rank, MPI_COMM_WORLD);
    traffic_.collectives += 2;
    return text;
}

int Comm::end(int status, const std::string& failure) const {
    if (!many()) return status;
    // A rank whose computation goes on is in no hurry; one that has failed alone would wait for ever.
    constexpr int patience = 5000;  // [ms]
    MPI_Request all_here;
    MPI_Ibarrier(farewell, &all_here);
    int here = 0;
    for (int waited = 0; !here; ++waited) {
        MPI_Test(&all_here, &here, MPI_STATUS_IGNORE);
        if (here) break;
        if (!failure.empty() && waited > patience) {
            std::fprintf(stderr, "%s\n", failure.c_str());
            MPI_Abort(MPI_COMM_WORLD, status);
        }
        usleep(1000);
    }
    MPI_Allreduce(MPI_IN_PLACE, &status, 1, MPI_INT, MPI_MAX, farewell);
    MPI_Finalize();
    return status;
}

#else

bool Comm::built_with_mpi() { return false; }

Comm Comm::started() {
    if (const int n = launched_processes(); n > 1)
        throw InputError(
            fmt::format("started as {} processes, and this twinwake was built without MPI: each would make the whole "
                        "run; install libopenmpi-dev and build anew, or start it once",
                        n));
    return {};
}

void Comm::combine_bytes(void*, std::size_t, std::size_t, const std::function<void(void*, const void*)>&) const {}
Comm::Bytes Comm::gathered_bytes(std::span<const std::byte> own) const { return {own.begin(), own.end()}; }
std::vector<Comm::Bytes> Comm::sent_to_first(const Bytes& own) const { return {own}; }
std::vector<Comm::Bytes> Comm::exchange(const std::vector<Bytes>&) const { return {{}}; }
void Comm::exchange(std::span<const Parcel>, std::span<Parcel>) const {}
std::string Comm::broadcast_from(int, std::string text) const { return text; }
int Comm::end(int status, const std::string&) const { return status; }

#endif

}  // namespace tw
