# SPDX-License-Identifier: GPL-2.0-or-later
"""The laws under which each row runs."""
from scripts import Variant

# Without dashpot and friction the laws are the same, whatever velocities they see.
STOCK = {
    "liggghts": Variant("stock", "gran model hooke/stiffness tangential off absolute_damping on",
                        ["fix integrate GROUP nve/sphere", "fix flat all enforce2d"], dashpots=False),
    "lammps": Variant("stock", "gran/hooke 352.1 0 0 0 0 0",
                      ["fix integrate GROUP nve/sphere disc", "fix flat all enforce2d"], dashpots=False)}
# With Eq. 1 it is that of LIGGGHTS if dashpots see the velocities of the half step.
STOCK_FRICTION = {
    "liggghts": Variant("stock_friction", "gran model hooke/stiffness tangential no_history absolute_damping on",
                        ["fix integrate GROUP nve/sphere", "fix flat all enforce2d"], one_run=True)}


def ours(engine, name, tangential, options="", **more):
    pair = ("gran model " if engine == "liggghts" else "") + "disc/linear tangential " + tangential
    return Variant(name, pair, [f"fix integrate GROUP nve/disc {options}".strip()], **more)


def of_row(row):
    """By name, in the order in which they run."""
    engine = row.engine
    spring = "disc/cundall_strack tangential_damping on"
    variants = [STOCK[engine], ours(engine, "ours", "off", dashpots=False), ours(engine, "open", spring),
                ours(engine, "looked_at", spring, looks=True), ours(engine, "closed", spring, "fused off")]
    # It is fix nve/disc that refuses.
    if engine in STOCK_FRICTION and not row.refused:
        friction = ours(engine, "half_step", "disc/viscous", "velocity half_step", one_run=True)
        # A second run of nve/disc goes on with the forces of the first one; nve/sphere begins it with others, of
        # dashpots that see the velocities of the whole step.
        if row.kind != "fix":
            friction.integrator = STOCK[engine].integrator
        variants += [STOCK_FRICTION[engine], friction]
    return {variant.name: variant for variant in variants}


# Who has to move as who, and whether to the last bit.
PAIRS = [("ours", "stock", False), ("half_step", "stock_friction", False), ("open", "looked_at", True),
         ("open", "closed", True)]
