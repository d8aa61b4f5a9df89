"""Opens a run in ParaView: water, hull with its pressure and bodies of both methods side by side, one camera for both.

    paraview --script=tools/paraview_both.py RUN
    pvpython tools/paraview_both.py RUN [--picture FILE.png] [--state FILE.pvsm] [--time SECONDS] [--below]

--below looks from under the water, where the pressure on the hull is; the mouse turns both views.

Where ParaView does not hand words on to its scripts: TWINWAKE_RUN=RUN paraview --script=... (docs/PARAVIEW.md).
ParaView 5.11 or newer. `sources` says what is opened and needs no ParaView.
"""

import json
import os
import re
import sys
import tempfile

METHODS = {"sph": "SPH", "fvm": "interFoam"}
# Colours [red, green, blue] from the lowest to the highest value: of the water's height, of the pressure on the hull.
WATER = [(0.03, 0.15, 0.40), (0.20, 0.45, 0.75), (0.80, 0.92, 1.00)]
PRESSURE = [(0.75, 0.75, 0.75), (0.95, 0.75, 0.20), (0.80, 0.05, 0.05)]
BODY = [0.80, 0.70, 0.50]


def sources(run):
    """What of a run is opened, by method: {"water": file, "hull": file, "bodies": [files], "decomposed": bool}.

    A file that is None is not there; water that is a .foam file is to be contoured at alpha.water = 0.5. Throws
    SystemExit with what was looked for.
    """
    found = {}
    snapshots = os.path.join(run, "sph", "snapshots")
    water = os.path.join(snapshots, "free_surface.vtp.series")
    if os.path.exists(water):
        hull = os.path.join(snapshots, "hull.vtp.series")
        bodies = sorted(os.path.join(snapshots, f) for f in os.listdir(snapshots)
                        if f.startswith("body_") and f.endswith(".vtp.series"))
        found["sph"] = {"water": water, "hull": hull if os.path.exists(hull) else None, "bodies": bodies,
                        "decomposed": False}
    case = os.path.join(run, "fvm", "case")
    if os.path.exists(os.path.join(case, "case.foam")):
        surface = series_of(run, case, "freeSurface", "freeSurface")
        found["fvm"] = {"water": surface or os.path.join(case, "case.foam"),
                        "hull": series_of(run, case, "hullSurface", "hull"),
                        "bodies": [series_of(run, case, "bodySurfaces", name)
                                   for name in names_below(os.path.join(case, "postProcessing", "bodySurfaces"))],
                        "decomposed": is_decomposed(case)}
    if not found:
        raise SystemExit(f"{run}: neither {os.path.relpath(water, run)} nor fvm/case/case.foam is there; expected the "
                         "folder of a finished run (runs of a suite and coarser twins leave no pictures)")
    return found


def is_time(name):
    return re.fullmatch(r"[0-9.]+(e-?[0-9]+)?", name) is not None


def times_in(folder):
    """Names of time folders, sorted by their times."""
    return sorted((n for n in os.listdir(folder) if is_time(n)), key=float) if os.path.isdir(folder) else []


def is_decomposed(case):
    """Whether its processors' folders have a later time than its own."""
    own, parts = times_in(case), times_in(os.path.join(case, "processor0"))
    return bool(parts) and (not own or float(parts[-1]) > float(own[-1]))


def names_below(folder):
    """The surfaces that a function object has written, by name."""
    return sorted({f[:-4] for t in times_in(folder) for f in os.listdir(os.path.join(folder, t)) if f.endswith(".vtp")})


def series_of(run, case, function, name):
    """A list of OpenFOAM's surface files with their times, as ParaView reads it; None where there are none."""
    folder = os.path.join(case, "postProcessing", function)
    files = [(os.path.join(folder, t, name + ".vtp"), float(t)) for t in times_in(folder)]
    files = [(f, t) for f, t in files if os.path.exists(f)]
    if not files:
        return None
    place = os.path.join(run, "fvm")
    if not os.access(place, os.W_OK):
        place = tempfile.mkdtemp(prefix="twinwake_")
    series = os.path.join(place, f"{name}.vtp.series")
    entries = [{"name": os.path.relpath(f, place), "time": t} for f, t in files]
    with open(series, "w", encoding="utf-8") as file:
        json.dump({"file-series-version": "1.0", "files": entries}, file, indent=1)
    return series


def is_half(low, high):
    """Whether a surface lies on one side of y = 0 and reaches it: half a model."""
    return abs(low) < 0.02 * (high - low)


def opened(files):
    """Readers of a method's files, as they are shown: {"water": ..., "hull": ..., "bodies": [...]}."""
    from paraview import simple

    if files["water"].endswith(".foam"):
        case = simple.OpenFOAMReader(FileName=files["water"], MeshRegions=["internalMesh"],
                                     CellArrays=["alpha.water"])
        case.CaseType = "Decomposed Case" if files["decomposed"] else "Reconstructed Case"
        case.UpdatePipelineInformation()
        case.UpdatePipeline(case.TimestepValues[-1] if len(case.TimestepValues) > 0 else 0)
        points = simple.CellDatatoPointData(Input=case)
        water = simple.Contour(Input=points, ContourBy=["POINTS", "alpha.water"], Isosurfaces=[0.5])
    else:
        water = simple.OpenDataFile(files["water"])
    hull = simple.OpenDataFile(files["hull"]) if files["hull"] else None
    return {"water": water, "hull": hull, "bodies": [simple.OpenDataFile(b) for b in files["bodies"] if b]}


def limits_of(sides, time):
    """Limits that both views share: of the water's height [m] and of the pressure on the hull [Pa]."""
    heights, pressures = [], []
    for side in sides.values():
        side["water"].UpdatePipeline(time)
        heights += side["water"].GetDataInformation().GetBounds()[4:6]
        if side["hull"]:
            side["hull"].UpdatePipeline(time)
            arrays = side["hull"].CellData if len(side["hull"].CellData.keys()) else side["hull"].PointData
            for name in ("pressure", "p"):
                if name in arrays.keys():
                    pressures.append(arrays[name].GetRange()[1])
    reach = max(min(abs(heights[i]) for i in range(len(heights)) if i % 2 == 1), 1e-3)
    return (-reach, reach), (0.0, max(min(pressures), 1.0) if pressures else 1.0)


def coloured(display, array, colours, limits):
    """Colours what is shown by an array, ("POINTS" or "CELLS", name), evenly between its limits."""
    from paraview import simple

    simple.ColorBy(display, array)
    function = simple.GetColorTransferFunction(array[1])
    low, high = limits
    function.RGBPoints = [number for i, colour in enumerate(colours)
                          for number in (low + (high - low) * i / (len(colours) - 1), *colour)]
    function.ColorSpace = "RGB"


def add_legend(view, array, title, place):
    """A legend of an array's colours on the right of a view; `place`: of its lower end, from 0 (low) to 1 (high)."""
    from paraview import simple

    bar = simple.GetScalarBar(simple.GetColorTransferFunction(array), view)
    bar.Visibility = 1
    bar.Title, bar.ComponentTitle, bar.TitleColor, bar.LabelColor = title, "", [0, 0, 0], [0, 0, 0]
    bar.TitleFontSize, bar.LabelFontSize, bar.HorizontalTitle = 14, 12, 1
    bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.80, place], 0.32


def show(run, time=None, below=False):
    """Both views; gives the times that there are."""
    files_of = sources(run)
    try:
        from paraview import simple
    except ImportError:
        raise SystemExit("this Python has no ParaView; start it with pvpython, or paraview --script=...") from None

    simple._DisableFirstRenderCameraReset()
    sides = {method: opened(files) for method, files in files_of.items()}
    times = sorted({t for side in sides.values() for t in getattr(side["water"], "TimestepValues", []) or []})
    time = times[-1] if time is None and times else time
    heights, pressures = limits_of(sides, time)
    layout = simple.CreateLayout(name="both methods")
    views = []
    for place, (method, side) in enumerate(sides.items()):
        view = simple.CreateView("RenderView")
        simple.AssignViewToLayout(view=view, layout=layout, hint=0)
        view.ViewTime = time or 0
        view.UseColorPaletteForBackground = 0
        view.Background = [1, 1, 1]
        view.OrientationAxesLabelColor = [0, 0, 0]
        bounds = side["water"].GetDataInformation().GetBounds()
        half = is_half(bounds[2], bounds[3])

        def shown(source):
            if half:
                source = simple.Reflect(Input=source, Plane="Y", Center=0.0)
            return source

        water = simple.Elevation(Input=shown(side["water"]), LowPoint=[0, 0, heights[0]], HighPoint=[0, 0, heights[1]],
                                 ScalarRange=list(heights))
        display = simple.Show(water, view)
        coloured(display, ("POINTS", "Elevation"), WATER, heights)
        display.SetScalarBarVisibility(view, False)
        if place == len(sides) - 1:
            add_legend(view, "Elevation", "height [m]", 0.06)
        display.Opacity = 0.8
        if side["hull"]:
            hull = shown(side["hull"])
            display = simple.Show(hull, view)
            data = hull.CellData if "pressure" in hull.CellData.keys() or "p" in hull.CellData.keys() else hull.PointData
            kind = "CELLS" if data is hull.CellData or "p" in hull.CellData.keys() or \
                "pressure" in hull.CellData.keys() else "POINTS"
            name = "pressure" if "pressure" in data.keys() else "p"
            if name in data.keys():
                coloured(display, (kind, name), PRESSURE, pressures)
                display.SetScalarBarVisibility(view, False)
                if place == len(sides) - 1:
                    add_legend(view, name, "pressure [Pa]", 0.56)
        for body in side["bodies"]:
            simple.Show(shown(body), view).DiffuseColor = BODY
        label = simple.Text(Text=METHODS[method])
        simple.Show(label, view).Color = [0, 0, 0]
        views.append(view)
    for view in views[1:]:
        simple.AddCameraLink(views[0], view, "both methods")
    camera = views[0]
    simple.ResetCamera(camera)
    camera.CameraViewUp = [0, 0, 1]
    focus = list(camera.CameraFocalPoint)
    away = camera.GetActiveCamera().GetDistance()
    camera.CameraPosition = [focus[0] - 0.5 * away, focus[1] - 0.7 * away, focus[2] + (-0.5 if below else 0.5) * away]
    for view in views:
        view.CameraPosition, view.CameraFocalPoint = camera.CameraPosition, camera.CameraFocalPoint
        view.CameraViewUp = camera.CameraViewUp
        simple.Render(view)
    return layout, times


def main(words):
    run = os.environ.get("TWINWAKE_RUN")
    below = False
    options = {"--picture": None, "--state": None, "--time": None}
    while words:
        word = words.pop(0)
        if word in ("-h", "--help"):
            print(__doc__.strip())
            return
        if word == "--below":
            below = True
            continue
        if word in options and words:
            options[word] = words.pop(0)
        elif not word.startswith("-"):
            run = word
        else:
            raise SystemExit(f"{word}: unknown; expected RUN, --picture FILE.png, --state FILE.pvsm, --time SECONDS, --below")
    if not run:
        raise SystemExit("expected the folder of a run: RUN, or the environment variable TWINWAKE_RUN")
    try:
        time = float(options["--time"]) if options["--time"] else None
    except ValueError:
        raise SystemExit(f"--time {options['--time']}: expected seconds") from None
    layout, times = show(os.path.abspath(run), time, below)
    from paraview import simple

    if options["--picture"]:
        simple.SaveScreenshot(options["--picture"], layout, ImageResolution=[1600, 700])
    if options["--state"]:
        simple.SaveState(options["--state"])
    print(f"{run}: {len(times)} times, the last {times[-1]:.6g} s" if times else f"{run}: one moment")


if __name__ in ("__main__", "__vtkconsole__"):
    main(sys.argv[1:])
