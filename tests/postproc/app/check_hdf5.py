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
    names = [f"{folder}/a{ending}" for ending in (".csv", ".h5", ".vtkhdf")]
    outs = [word for name in names for word in ("--out", name)]
    subprocess.run([program, "average", *dumps, "--rings", "0", "4", "2", "--bulk-types", "1", *outs], check=True)
    csv = pandas.read_csv(names[0], comment="#", float_precision="round_trip")

    with h5py.File(names[1]) as file:
        table = file["table"]
        frame = pandas.DataFrame({name: table[name][:] for name in table.attrs["columns"]})
        assert list(frame.columns) == list(csv.columns)
        assert numpy.array_equal(frame.values, csv.values, equal_nan=True)
        assert table["sigma_rr"].attrs["unit"] == "Pa"
        assert table["sigma_rr"].attrs["equation"].startswith("seed Eq.")
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

    subprocess.run([program, "convert", *dumps, "--timestep", "0.01", "--out", f"{folder}/s.h5"], check=True)
    with h5py.File(f"{folder}/s.h5") as file:
        assert list(file["h5md"].attrs["version"]) == [1, 1]
        discs = file["particles/discs"]
        assert list(discs["position/step"]) == [100, 200] and list(discs["id/time"]) == [1, 2]
        assert discs["position/value"].shape == (2, 4, 2) and discs["position/value"].attrs["unit"] == "m"
        assert list(discs["box"].attrs["boundary"]) == ["none", "none"]
        assert list(file["contacts/offset"]) == [0, 3, 6] and list(file["contacts/id2"][:3]) == [3, 3, 0]
print("h5py and pandas see what the CSV says")
