# SPDX-License-Identifier: GPL-2.0-or-later
"""Scripts of one row under one law: the discs, the law, who integrates, the row's lines, its runs."""
import math
import os
import random

STEPS = 200  # of each of two runs
TIME_STEP = 4e-5
LOW, HIGH = -0.04, 0.06
CONSTANTS = {"kn": 352.1, "gamman_abs": 0.19, "kt": 281.68, "gammat_abs": 0.15, "coefficientFriction": 0.44}
TYPES = 3

# What rows read.
DISC = "a disc\n\n1 atoms\n\nCoords\n\n1 0 0 0\n\nTypes\n\n1 1\n\nDiameters\n\n1 {}\n\nMasses\n\n1 4e-4\n"
FILES = {"one.mol": DISC.format(0.009), "large.mol": DISC.format(0.016)}


class Variant:
    """A law, and who integrates under it; whether somebody looks in every step, and whether there is one run, not two."""

    def __init__(self, name, pair, integrator, dashpots=True, looks=False, one_run=False):
        self.name, self.pair, self.integrator, self.dashpots, self.looks = name, pair, integrator, dashpots, looks
        self.one_run = one_run


def discs():
    """Some of them touch from the first step on; all meet others within the first run."""
    numbers = random.Random(5)
    lines = []
    for row in range(4):
        for column in range(5):
            a = numbers.uniform(0.0042, 0.005)
            x = -0.0204 + 0.0102 * column + numbers.uniform(-4e-4, 4e-4)
            y = -0.018 + 0.0102 * row + numbers.uniform(-4e-4, 4e-4)
            speed, angle, spin = numbers.uniform(0.1, 0.5), numbers.uniform(0, 2 * math.pi), numbers.uniform(-20, 20)
            lines.append((x, y, a, speed * math.cos(angle), speed * math.sin(angle), spin))
    return lines


def disc_lines(engine, faster):
    density, spin = ("density", "omegaz") if engine == "liggghts" else ("density/disc", "omega 0 0")
    units = " units box"
    lines = []
    for number, (x, y, a, v_x, v_y, omega) in enumerate(discs(), 1):
        lines += [f"create_atoms {1 + number % 2} single {x:.17g} {y:.17g} 0{units}",
                  f"set atom {number} diameter {2 * a:.17g} {density} 6.36",
                  f"set atom {number} vx {faster * v_x:.17g} vy {faster * v_y:.17g} {spin} {omega:.17g}"]
    return lines


def constants(variant):
    return {name: value * (variant.dashpots or not name.startswith("gamma")) for name, value in CONSTANTS.items()}


def law(engine, variant):
    """Constants and pair style."""
    given = constants(variant)
    if engine == "liggghts":
        values = {name: " ".join([f"{value:.17g}"] * TYPES**2) for name, value in given.items()}
        return [f"fix {name} all property/global {name} peratomtypepair {TYPES} {text}" for name, text in
                values.items()] + [f"pair_style {variant.pair}", "pair_coeff * *"]
    if variant.pair.startswith("gran/"):
        return [f"pair_style {variant.pair}", "pair_coeff * *"]
    return [f"pair_style {variant.pair}", coefficients(given)]


def coefficients(given):
    words = {"kn": "kn", "gamman_abs": "gamman", "kt": "kt", "gammat_abs": "gammat", "coefficientFriction": "mu"}
    return "pair_coeff * * " + " ".join(f"{words[name]} {value:.17g}" for name, value in given.items())


def softer(variant):
    """LAMMPS's way of other constants between two runs."""
    if variant.pair.startswith("gran/"):
        return ["pair_style gran/hooke 200 0 0 0 0 0", "pair_coeff * *"]
    return [coefficients({**constants(variant), "kn": 200.0})]


def integrators(variant, group):
    return [line.replace("GROUP", group) for line in variant.integrator]


def integrate(variant, group):
    """And who looks in every step."""
    looks = ["thermo_style custom step", "thermo 1"] if variant.looks else ["thermo 100000"]
    return integrators(variant, group) + looks


def start(engine, row):
    if engine == "liggghts":
        its = ["atom_style " + (row.atom_style or "granular"), "atom_modify map array", "communicate single vel yes"]
    else:
        # Its fix pour writes behind the end of a map that is an array.
        its = ["atom_style " + (row.atom_style or "sphere"), "atom_modify map hash", "comm_modify mode single vel yes"]
    return ["units si", "dimension 2", "newton off", *its]


def set_up(engine, row, faster):
    return [*start(engine, row), f"boundary {row.boundary}", *row.before_box,
            f"region box block -{row.half_width} {row.half_width} {LOW} {HIGH} -0.005 0.005 units box",
            f"create_box {TYPES} box {row.box}", "neighbor 0.001 bin", "neigh_modify delay 0",
            *(disc_lines(engine, faster) if row.discs == "all" else []),
            *(["group some id 3 7 8 13 19", "group rest subtract all some"] if row.discs == "all" else [])]


def expanded(lines, blocks):
    """Lines, of which some stand for several."""
    for line in lines:
        if line in blocks:
            yield from blocks[line]
        else:
            yield line


def own(lines, variant):
    """Those that are meant for this law, or rather for its integrator."""
    is_ours = any("nve/disc" in line for line in variant.integrator)
    other, its = ("stock:", "disc:") if is_ours else ("disc:", "stock:")
    return [line.removeprefix(its).strip() for line in lines if not line.startswith(other)]


def with_runs(row, variant):
    if row.kind == "fix":
        return [*row.lines, *([f"run {2 * STEPS}"] if variant.one_run else [f"run {STEPS}"] * 2)]
    if row.kind == "between":
        return [f"run {STEPS}", *row.lines, f"run {STEPS}"]
    return row.lines


def of_row(engine, row, variant, out, faster=1):
    """`out`: how the names of its files begin; `faster`: what velocities are multiplied by."""
    blocks = {"{law}": law(engine, variant), "{softer}": softer(variant), "{start}": start(engine, row),
              "{integrate}": integrate(variant, row.integrate), "{again}": integrators(variant, row.integrate),
              "{second}": [integrators(variant, "some")[0].replace("fix integrate", "fix second")]}
    rows_own = row.kind == "fix" and "{integrate}" in row.lines
    first = [] if rows_own else blocks["{integrate}"]
    lines = [*set_up(engine, row, faster), *blocks["{law}"], *first, f"timestep {TIME_STEP}",
             *expanded(own(with_runs(row, variant), variant), blocks), *last_frame(engine, out)]
    return [line.replace("{out}", out).replace("{folder}", os.path.dirname(out)) for line in lines]


def out_of(row, name, folder):
    """How the names of the files of a row under a variant of that name begin."""
    return os.path.join(folder, f"{row.file_name()}.{name}.")


def write_files(folder):
    """Into a folder that no other run has left its files in."""
    os.makedirs(folder, exist_ok=True)
    if os.listdir(folder):
        raise SystemExit(f"{folder}: expected an empty folder")
    for name, text in FILES.items():
        with open(os.path.join(folder, name), "w") as file:
            file.write(text)


def last_frame(engine, out):
    numbers = " ".join(["%.17g"] * 7)
    how = f'format "%d %d {numbers}"' if engine == "liggghts" else f'format line "%d %d {numbers}"'
    return [f"write_dump all custom {out}last.dump id type x y vx vy omegaz radius mass modify sort id {how}"]
