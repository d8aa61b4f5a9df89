#pragma once
#include <string>
#include <vector>

#include "app/cluster/site.h"
#include "app/study/study.h"

namespace tw::app {

/// One array of jobs: runs of one method on as many cores, of particles on as many ranks with so many cores each.
struct JobArray {
    std::string method;
    int cores = 1, ranks = 1;
    std::vector<std::size_t> members = {};
    double seconds = 0,
           bytes = 0;  ///< [s], [bytes] asked for, with margin: of the largest of them, or of its largest rank

    std::string name() const;  ///< "sph_4"; of several ranks "sph_8x4"
};

/// What jobs ask for beyond what is predicted: the machine that submits may be faster than a node, and a run may have
/// more particles in the end than on average.
inline constexpr double margin_of_time = 2, least_time = 600;                    ///< factor, [s] on top
inline constexpr double margin_of_memory = 1.3, least_memory = 512.0 * 1048576;  ///< factor, [bytes] on top
/// The members by what they ask for; those of a request that has its threads keep them.
std::vector<JobArray> arrays_of(const Study& study, const Site& site);

/// Batch scripts. Text from scenes is in neither; the site's words are checked or quoted. They are submitted in the
/// folder study/, where their members are named by number.
std::string array_script(const JobArray& array, const Site& site, const std::string& program, const std::string& probe);
/// `where`: the folder in which the study's command was given.
std::string report_script(const Study& study, const Site& site, const std::string& program, double bytes);

/// "0-02:30:00", as Slurm writes a time; minutes rounded up.
std::string slurm_time(double seconds);

}  // namespace tw::app
