# SPDX-License-Identifier: GPL-2.0-or-later
"""What h5py and pandas see in the HDF5 files of the program given as argument: the numbers of the CSV, bit by bit."""

import subprocess
import sys
import tempfile

import h5py
import numpy
import pandas

program = sys.argv[1]
dumps = ["--particles", "particles.dump", "--contacts", "contacts.dump"]

with tempfile.TemporaryDirectory() as folder:
    names = [f"{folder}/a{ending}" for ending in (".csv", ".h5", ".vtkhdf", ".hdf")]
    outs = [word for name in names for word in ("--out", name)]
    subprocess.run([program, "average", *dumps, "--rings", "0", "4", "2", "--bulk-types", "1", "--height", "0.5", *outs], check=True)
    csv = pandas.read_csv(names[0], comment="#", float_precision="round_trip")

    with h5py.File(names[1]) as file:
        table = file["table"]
        frame = pandas.DataFrame({name: table[name][:] for name in table.attrs["columns"]})
        assert list(frame.columns) == list(csv.columns)
        assert numpy.array_equal(frame.values, csv.values, equal_nan=True)
        assert table["sigma_rr"].attrs["unit"] == "Pa"
        assert table["sigma_rr"].attrs["equation"].startswith("Latzel2001 Eq.")
        assert file.attrs["program"].startswith("mikromakro ")
        assert file.attrs["weight"] == "sliced" and file.attrs["particles"] == "particles.dump"

    with h5py.File(names[2]) as file:
        grid = file["VTKHDF"]
        kind = grid.attrs.get_id("Type").get_type()
        assert not kind.is_variable_str() and kind.get_cset() == h5py.h5t.CSET_ASCII
        assert grid.attrs["Type"] == b"UnstructuredGrid" and list(grid.attrs["Version"]) == [1, 0]
        cells, points, ids = (grid[f"NumberOf{what}"][0] for what in ("Cells", "Points", "ConnectivityIds"))
        assert cells == 2 * 180 and grid["Types"].dtype == numpy.uint8 and set(grid["Types"][:]) == {7}
        assert grid["Points"].shape == (points, 3) and grid["Connectivity"].shape == (ids,)
        assert grid["Offsets"].shape == (cells + 1,) and grid["Offsets"][-1] == ids
        radii = numpy.hypot(*grid["Points"][:, :2].T)
        assert set(numpy.round(radii, 12)) == {0, 2, 4}
        assert numpy.array_equal(grid["CellData/sigma_rr"][::180], csv["sigma_rr"], equal_nan=True)

    # Vectors and tensors: x, y, z and xx, xy, xz, yx ... of the mean polar components, along e_r and e_phi in the middle of each polygon.
    def rotated(file, rows, phi):
        cell = file["VTKHDF/CellData"]
        r, p = numpy.array([numpy.cos(phi), numpy.sin(phi)]), numpy.array([-numpy.sin(phi), numpy.cos(phi)])
        v, sigma, couple = cell["v"][:], cell["sigma"][:].reshape(-1, 3, 3), cell["M"][:].reshape(-1, 3, 3)
        assert v.shape == (len(phi), 3) and cell["sigma"].shape == (len(phi), 9)
        along = {"r": r, "phi": p}
        for a, one in along.items():
            assert numpy.allclose((v[:, :2].T * one).sum(axis=0), rows[f"v_{a}"], rtol=0, atol=1e-14, equal_nan=True)
            assert numpy.allclose(numpy.einsum("nj,jn->n", couple[:, 2, :2], one), rows[f"M_z{a}"], rtol=0, atol=1e-14, equal_nan=True)
            for b, other in along.items():
                both = numpy.einsum("in,nij,jn->n", one, sigma[:, :2, :2], other)
                assert numpy.allclose(both, rows[f"sigma_{a}{b}"], rtol=0, atol=1e-14, equal_nan=True), (a, b)
        assert not v[:, 2].any() and not sigma[:, 2].any() and not sigma[:, :, 2].any() and not couple[:, :2].any()
        assert "v_err" not in cell and "eps" in cell and cell["eps"].shape == (len(phi), 9)

    with h5py.File(names[2]) as file:
        rotated(file, csv.loc[csv.index.repeat(180)], numpy.radians(numpy.tile(numpy.arange(180) * 2 + 1, 2)))

    # The ending by which ParaView 5.11 knows the files.
    with h5py.File(names[3]) as file:
        assert numpy.array_equal(file["VTKHDF/CellData/sigma_rr"][::180], csv["sigma_rr"], equal_nan=True)

    # Sectors and rectangles: each volume's polygons fill just its area, and nothing else.
    def cells(volumes):
        subprocess.run([program, "average", *dumps, *volumes, "--bulk-types", "1", "--out", names[0], "--out", names[2]],
                       check=True)
        with h5py.File(names[2]) as file:
            grid = file["VTKHDF"]
            points, ends = grid["Points"][:, :2], grid["Offsets"][:]
            nu = grid["CellData/nu"][:]
            return [points[grid["Connectivity"][a:b]] for a, b in zip(ends, ends[1:])], nu

    def area(polygon):
        x, y = polygon.T
        return 0.5 * (x * numpy.roll(y, -1) - y * numpy.roll(x, -1)).sum()

    polygons, nu = cells(["--rings", "1", "3", "2", "--sectors", "7", "--center", "0.5", "-0.25"])
    table = pandas.read_csv(names[0], comment="#", float_precision="round_trip")
    pieces = 26  # 360/7 degrees in pieces of 2 degrees at most
    assert len(polygons) == 2 * 7 * pieces and numpy.array_equal(nu[::pieces], table["nu"])
    for row in range(14):
        corners = numpy.concatenate(polygons[row * pieces : (row + 1) * pieces]) - [0.5, -0.25]
        phi = numpy.degrees(numpy.arctan2(corners[:, 1], corners[:, 0])) % 360
        off_middle = (phi - table["phi"][row] + 180) % 360 - 180
        assert abs(off_middle.min() + 180 / 7) < 1e-9 and abs(off_middle.max() - 180 / 7) < 1e-9
        filled = sum(area(polygon) for polygon in polygons[row * pieces : (row + 1) * pieces])
        r = numpy.hypot(*corners.T)
        assert abs(r.min() - table["r_inner"][row]) < 1e-12 and abs(r.max() - table["r_outer"][row]) < 1e-12
        exact = numpy.pi / 7 * (table["r_outer"][row] ** 2 - table["r_inner"][row] ** 2)
        # chords instead of arcs: sin(x)/x with x = 360/7/26 degrees
        angle = 2 * numpy.pi / 7 / pieces
        assert abs(filled / exact - numpy.sin(angle) / angle) < 1e-12

    with h5py.File(names[2]) as file:
        phi = numpy.radians([360 / 7 * (sector + (piece + 0.5) / pieces) for _ in range(2) for sector in range(7) for piece in range(pieces)])
        rotated(file, table.loc[table.index.repeat(pieces)], phi)

    cells(["--rings", "1", "3", "2", "--components", "cartesian"])
    table = pandas.read_csv(names[0], comment="#", float_precision="round_trip")
    with h5py.File(names[2]) as file:
        assert numpy.array_equal(file["VTKHDF/CellData/v"][::180, :2], table[["v_x", "v_y"]], equal_nan=True)
        assert numpy.array_equal(file["VTKHDF/CellData/sigma"][::180, [0, 1, 3, 4]], table[[f"sigma_{c}" for c in ("xx", "xy", "yx", "yy")]], equal_nan=True)

    # Windows: vectors and tensors of each frame, one after the other.
    windows = [program, "average", *dumps, "--rings", "0", "4", "2", "--bulk-types", "1", "--quiet"]
    subprocess.run([*windows, "--per-frame", "--out", f"{folder}/w.vtkhdf"], check=True)
    for frame in (0, 1):
        subprocess.run([*windows, "--frames", f"{frame}:{frame}", "--out", names[2]], check=True)
        with h5py.File(f"{folder}/w.vtkhdf") as series, h5py.File(names[2]) as single:
            for name in ("v", "sigma", "kappa"):
                begin = series[f"VTKHDF/Steps/CellDataOffsets/{name}"][frame]
                own = single[f"VTKHDF/CellData/{name}"][:]
                assert begin == 360 * frame and numpy.array_equal(series[f"VTKHDF/CellData/{name}"][begin : begin + 360], own, equal_nan=True), name

    polygons, nu = cells(["--grid", "-1", "2", "3", "-2", "0", "4"])
    table = pandas.read_csv(names[0], comment="#", float_precision="round_trip")
    assert len(polygons) == 12 and numpy.array_equal(nu, table["nu"])
    for polygon, (_, row) in zip(polygons, table.iterrows()):
        assert list(polygon.min(axis=0)) == [row["x_min"], row["y_min"]]
        assert list(polygon.max(axis=0)) == [row["x_max"], row["y_max"]] and abs(area(polygon) - 0.5) < 1e-15

    subprocess.run([program, "convert", *dumps, "--timestep", "0.01", "--out", f"{folder}/s.h5"], check=True)
    with h5py.File(f"{folder}/s.h5") as file:
        # H5MD 1.1, h5md.html: "Global attributes", "Modules: units", "Simulation box", "Particles group"
        assert list(file["h5md"].attrs["version"]) == [1, 1]
        assert file["h5md/author"].attrs["name"] and file["h5md/creator"].attrs["name"] == "mikromakro"
        assert file["h5md/creator"].attrs["version"]
        units = file["h5md/modules/units"].attrs
        assert list(units["version"]) == [1, 0] and units["system"] == "SI"
        box = file["particles/discs/box"]
        assert box.attrs["dimension"] == 2 and box.attrs["dimension"].shape == ()
        for element in (box["edges"], *(file["particles/discs"][name] for name in file["particles/discs"] if name != "box")):
            assert element["step"].dtype.kind == "i" and element["time"].dtype.kind == "f"
            assert element["value"].shape[0] == len(element["step"]) == len(element["time"]) == 2
        assert box["edges/value"].shape == (2, 2) and list(box["edges/value"][0]) == [10, 10]
        assert file["particles/discs/id/value"].fillvalue == -1 and file["particles/discs/id/value"].dtype.kind == "i"
        discs = file["particles/discs"]
        assert list(discs["position/step"]) == [100, 200] and list(discs["id/time"]) == [1, 2]
        assert discs["position/value"].shape == (2, 4, 2) and discs["position/value"].attrs["unit"] == "m"
        assert list(discs["box"].attrs["boundary"]) == ["none", "none"]
        assert list(discs["box"].attrs["periodic"]) == [0, 0]
        assert list(file["contacts/offset"]) == [0, 3, 6] and list(file["contacts/id2"][:3]) == [3, 3, 0]
print("h5py and pandas see what the CSV says")
