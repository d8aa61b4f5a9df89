#pragma once
// The kernels by name, once for all who make or start them.

// Sweeps over groups and their neighbours: sweep(NAME, VIEW).
#define TW_DEVICE_SWEEPS(sweep)                                                                             \
    sweep(tw_prune, PruneData) sweep(tw_first_sweep, FirstSweepData) sweep(tw_second_sweep, SecondSweepData) \
        sweep(tw_extrapolate, ExtrapolateData)

// One index by one thread: task(NAME, TASK).
#define TW_DEVICE_TASKS(task)                                                                                      \
    task(tw_update_records, UpdateRecords) task(tw_refresh_images, cuda::RefreshImages)                            \
        task(tw_mark_surface, cuda::MarkSurface) task(tw_mark_air, cuda::MarkAir) task(tw_note_air, cuda::NoteAir) \
            task(tw_compress, cuda::Compress) task(tw_take_held, cuda::TakeHeld) task(tw_put_held, cuda::PutHeld)
