# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of a sweep: a row for each job, and a row for each point of the grid with the spread over seeds."""
import itertools
import os

import pandas

from student_t import mean_error
from sweeping.results import unit_of, value_of


def job_rows(plan, jobs):
    """Variables of the grid, seed, results."""
    return [{**dict(zip(plan.grid, job.point)), **({"seed": job.seed} if plan.seeds else {}),
             **{one.name: value_of(one, job.folder) for one in plan.results}} for job in jobs]


def point_rows(plan, rows):
    """Variables of the grid, number of seeds, means, then NAME_err and NAME_95 of each (68 and 95 % of Student's t of the mean, nan of one seed).
    Where a seed has no number, the mean has none either."""
    points = []
    for point, group in itertools.groupby(rows, lambda row: [row[name] for name in plan.grid]):
        own = list(group)
        row = {**dict(zip(plan.grid, point)), "seeds": len(own)}
        values = {one.name: [job[one.name] for job in own] for one in plan.results}
        row |= {name: mean_error(value)[0] for name, value in values.items()}
        row |= {f"{name}_err": mean_error(value)[1] for name, value in values.items()}
        row |= {f"{name}_95": mean_error(value, 0.95)[1] for name, value in values.items()}
        points.append(row)
    return points


def tables(plan, jobs):
    """Of the jobs, and of the points of the grid."""
    rows = job_rows(plan, jobs)
    return pandas.DataFrame(rows), pandas.DataFrame(point_rows(plan, rows))


def units(plan, job):
    return {one.name: unit_of(one, job.folder) for one in plan.results}


def notes(plan, unit):
    """What stands above a table."""
    lines = [f"sweep: {plan.file}", f"script: {plan.script} ({plan.program})",
             f"variables: {' '.join(f'{name} {value}' for name, value in plan.variables.items()) or 'those of the script'}"]
    lines += [f"column {one.name} [{unit[one.name] or 'unit not given'}] {one.text()}" for one in plan.results]
    if plan.seeds:
        lines.append("column ..._err standard error of the mean over seeds, widened for their number: 68 % of Student's t; ..._95 half the interval of 95 %")
    return lines


def save(path, table, lines):
    with open(path + ".new", "w") as file:
        file.writelines(f"# {line}\n" for line in lines)
        table.to_csv(file, index=False, na_rep="nan")
    os.replace(path + ".new", path)
