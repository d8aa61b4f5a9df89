#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/cloud/cloud_case.h"
#include "foam_cases/read/number_rows.h"
#include "foam_cases/read/time_folders.h"

namespace tw {
namespace fs = std::filesystem;
namespace {

/// The numbers of a parcel field of `width` numbers a parcel, as ascii text: n(a b ...) or, where those of all `parcels`
/// are the same, n{a}.
std::vector<double> parcel_numbers(const fs::path& file, std::size_t width, std::size_t parcels) {
    const auto fail = [&](const std::string& why) {
        return RunError(file.string() + ": " + why + "; the solver was probably stopped while it wrote");
    };
    if (!fs::exists(file)) throw fail("is not there");
    const std::string text = read_text(file);
    const std::size_t header = text.find('}');
    const std::size_t rule = header == std::string::npos ? header : text.find("//", header);
    const std::size_t begin = rule == std::string::npos ? rule : text.find('\n', rule);
    const std::size_t end = text.find_last_of(")}");
    if (begin == std::string::npos || end == std::string::npos || end <= begin) throw fail("is cut off");
    std::vector<double> numbers = numbers_in(std::string_view(text).substr(begin, end - begin));
    if (numbers.empty() || !(numbers[0] >= 0) || numbers[0] > 1e9) throw fail("holds no number of parcels");
    const auto n = static_cast<std::size_t>(numbers[0]);
    numbers.erase(numbers.begin());
    if (text[end] == '}' && numbers.size() == width) {
        if (n != parcels) throw fail("is of another number of parcels");
        const std::vector<double> one = numbers;
        for (std::size_t i = 1; i < n; ++i) numbers.insert(numbers.end(), one.begin(), one.end());
    }
    if (numbers.size() != n * width) throw fail("is cut off");
    return numbers;
}

}  // namespace

std::vector<std::vector<ParcelState>> read_cloud(const fs::path& folder) {
    std::vector<std::vector<ParcelState>> frames;
    for (const TimeFolders::Moment& moment : TimeFolders(folder).moments()) {
        const fs::path at = folder / moment.name / "lagrangian" / "kinematicCloud";
        if (!fs::exists(at / "positions") && !fs::exists(at / "origId")) {  // all parcels have left the room
            frames.emplace_back();
            continue;
        }
        const auto names = parcel_numbers(at / "origId", 1, 1);  // each has its own
        const std::size_t n = names.size();
        const auto places = parcel_numbers(at / "positions", 4, n),  // and the cell
            velocities = parcel_numbers(at / "U", 3, n), ages = parcel_numbers(at / "age", 1, n);
        for (const double name : names)
            if (!(name >= 0 && name <= 1e9)) throw RunError((at / "origId").string() + ": holds no names of parcels");
        if (places.size() != 4 * n || velocities.size() != 3 * n || ages.size() != n)
            throw RunError(at.string() + ": its fields are of different numbers of parcels");
        std::vector<ParcelState>& frame = frames.emplace_back(n);
        for (std::size_t i = 0; i < n; ++i)
            frame[i] = {static_cast<std::size_t>(names[i]),
                        ages[i],
                        {places[4 * i], places[4 * i + 1], places[4 * i + 2]},
                        {velocities[3 * i], velocities[3 * i + 1], velocities[3 * i + 2]}};
    }
    if (frames.empty()) throw RunError(folder.string() + ": the cloud has written no time after 0");
    return frames;
}

}  // namespace tw
