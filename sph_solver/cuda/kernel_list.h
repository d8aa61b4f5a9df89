#pragma once
// The kernels by name and by the type of what they do, once for all who make or start them (launch.h): a line each.
// clang-format off

// Pair loops over clusters and their neighbours: pair loop(NAME, VIEW).
#define TW_DEVICE_PAIR_LOOPS(pair_loop)             \
    pair_loop(tw_prune,            PruneData)          \
    pair_loop(tw_first_pair_loop,  FirstPairLoopData)  \
    pair_loop(tw_second_pair_loop, SecondPairLoopData) \
    pair_loop(tw_extrapolate,      ExtrapolateData)    \
    pair_loop(tw_interpolate,      InterpolateData)

// One index by one thread: task(NAME, TASK).
#define TW_DEVICE_TASKS(task)                                    \
    task(tw_pack_state,              PackState)                  \
    task(tw_refresh_images,          cuda::RefreshImagesAtRest)  \
    task(tw_refresh_images_in_frame, cuda::RefreshImagesInFrame) \
    task(tw_mark_surface,            cuda::MarkSurface)          \
    task(tw_compress,                cuda::CompressLinearly)     \
    task(tw_compress_by_state,       cuda::CompressByState)      \
    task(tw_take_held,               cuda::TakeHeld)             \
    task(tw_put_held,                cuda::PutHeld)              \
    task(tw_cross,                   cuda::Cross)                \
    task(tw_enter,                   cuda::Enter)                \
    task(tw_put_back,                cuda::PutBack)              \
    task(tw_put_in_bins,             cuda::PutInBins)            \
    task(tw_rank_in_bins,            cuda::RankInBins)           \
    task(tw_reorder,                 cuda::Reorder)              \
    task(tw_count_images,            cuda::CountImages)          \
    task(tw_find_images,             cuda::FindImages)           \
    task(tw_reorder_links,           cuda::ReorderLinks)         \
    task(tw_count_clusters,          cuda::CountClusters)        \
    task(tw_make_clusters,           cuda::MakeClusters)         \
    task(tw_centre_clusters,         cuda::CentreClusters)       \
    task(tw_count_wall_loads,        cuda::CountWallLoads)       \
    task(tw_list_clusters_at_walls,  cuda::ListClustersAtWalls)  \
    task(tw_take_near_walls,         cuda::TakeNearWalls)        \
    task(tw_no_walls,                cuda::NoWalls)              \
    task(tw_put_walls,               cuda::PutWalls)             \
    task(tw_mark_pressed,            cuda::MarkPressed)          \
    task(tw_add_pushes,              AddPushes)                  \
    task(tw_mark_following,          cuda::MarkFollowing)        \
    task(tw_list_marked,             cuda::ListMarked)           \
    task(tw_places_to_ask,           cuda::PlacesToAsk)          \
    task(tw_mark_giving,             cuda::MarkGiving)           \
    task(tw_put_giving,              cuda::PutGiving)            \
    task(tw_start_giving,            cuda::StartGiving)          \
    task(tw_sort_asked,              cuda::SortAsked)            \
    task(tw_hand_to_buffers,         cuda::HandToBuffers)        \
    task(tw_hand_to_under,           cuda::HandToUnder)          \
    task(tw_hand_to_host,            cuda::HandToHost)           \
    task(tw_ask_coarse,              cuda::LabelCoarseAsked)     \
    task(tw_ask_fine,                cuda::LabelFineAsked)       \
    task(tw_leave_zone,              cuda::LeaveZone)            \
    task(tw_mark_gone,               cuda::MarkGone)             \
    task(tw_mark_staying,            cuda::MarkStaying)          \
    task(tw_mark_parents,            cuda::MarkParents)          \
    task(tw_take_parents,            cuda::TakeParents)          \
    task(tw_mark_between,            cuda::MarkBetween)          \
    task(tw_take_located,            cuda::TakeLocated)          \
    task(tw_add_daughters,           cuda::AddChildren)          \
    task(tw_forget_edge,             cuda::ForgetEdge)           \
    task(tw_pack_message,            cuda::PackMessage)          \
    task(tw_unpack_message,          cuda::UnpackMessage)        \
    task(tw_take_wide,               cuda::TakeWide)             \
    task(tw_mark_in_pencils,         cuda::MarkInPencils)        \
    task(tw_mark_own,                cuda::MarkOwn)              \
    task(tw_start_marked,            cuda::StartMarked)          \
    task(tw_places_ahead,            cuda::PlacesAhead)          \
    task(tw_work_of_clusters,        cuda::WorkOfClusters)

// The same, of tasks that count: they are given an atomic `add_one(counter)`.
#define TW_DEVICE_COUNTING_TASKS(task)                \
    task(tw_count_kinds,   CountKinds)             \
    task(tw_count_in_bins, cuda::CountInBins)      \
    task(tw_label_coarse,  cuda::LabelCoarseKnown) \
    task(tw_label_fine,    cuda::LabelFineKnown)

// Clusters by a condition: choose(NAME, CONDITION).
#define TW_DEVICE_CHOICES(choose) \
    choose(tw_has_neighbours, cuda::HasNeighbours)

// One index by one thread, and the largest of what they give: largest(NAME, TASK).
#define TW_DEVICE_LARGEST(largest)       \
    largest(tw_fastest, cuda::FastestOf)

// Kernels that are written out (kernels.cpp): other(NAME, TASK).
#define TW_DEVICE_OTHERS(other)                      \
    other(tw_move,            cuda::MoveAll)          \
    other(tw_search,          cuda::SearchNeighbours) \
    other(tw_scan_blocks,     cuda::ScanBlocks)       \
    other(tw_scan_sums,       cuda::ScanSums)         \
    other(tw_scan_fill,       cuda::ScanFill)         \
    other(tw_peak_arithmetic, cuda::PeakArithmetic)   \
    other(tw_peak_cache,      cuda::PeakCache)

// clang-format on
