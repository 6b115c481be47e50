"""Arguments: folder of a run, its end time [s]. Names, units, ranges and times as ParaView's readers see them."""
import sys

from paraview.simple import PVDReader, UpdatePipeline

# name: smallest and largest believable value of its magnitude, in the unit of the name
PARTICLES = {"velocity [m/s]": (0, 50), "diameter [m]": (1e-5, 0.1), "material_diameter [m]": (1e-5, 0.1)}
GAS = {"gas_velocity [m/s]": (0, 200), "pressure [Pa]": (-1e5, 1e5), "gas_fraction [1]": (0.2, 1.0001)}


def check(file, wanted, arrays_of, end):
    reader = PVDReader(FileName=file)
    times = list(reader.TimestepValues)
    assert len(times) >= 4 and times == sorted(times) and times[0] == 0, times
    assert abs(times[-1] - end) < 0.01 * end, times
    for time in times:
        UpdatePipeline(time=time, proxy=reader)
        arrays = arrays_of(reader)
        for name, (low, high) in wanted.items():
            array = arrays.GetArray(name)
            assert array is not None, f"{file}: no array {name} among {[a.Name for a in arrays]}"
            smallest, largest = array.GetRange(-1 if array.GetNumberOfComponents() > 1 else 0)
            assert low <= smallest <= largest <= high, f"{name} at {time} s: {smallest} ... {largest}"


folder, end = sys.argv[1], float(sys.argv[2])
check(folder + "/particles.pvd", PARTICLES, lambda reader: reader.PointData, end)
check(folder + "/fluid.pvd", GAS, lambda reader: reader.CellData, end)
print("ParaView reads every array at every time")
