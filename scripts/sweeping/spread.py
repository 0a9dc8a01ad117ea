# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of a sweep: a row for each job, and a row for each point of the grid with the spread over seeds."""
import itertools
import math
import os

import pandas

from student_t import mean_error
from sweeping.refused import NoResult
from sweeping.results import unit_of, value_of


class Lacking:
    """Results that could not be taken from the files of a job."""

    def __init__(self):
        self.jobs = {}

    def value(self, result, job):
        """nan where there is none."""
        try:
            return value_of(result, job.folder)
        except NoResult as error:
            self.jobs.setdefault((result.name, str(error).removeprefix(job.folder)), []).append(job)
            return math.nan

    def lines(self):
        """One for all jobs that lack the same."""
        return [f"{jobs[0].folder}{error}; {name} is nan there" + (f" and in {len(jobs) - 1} more jobs" if len(jobs) > 1 else "")
                for (name, error), jobs in self.jobs.items()]


def job_rows(plan, jobs, lacking):
    """Variables of the grid, seed, results."""
    return [{**dict(zip(plan.grid, job.point)), **({"seed": job.seed} if plan.seeds else {}),
             **{one.name: lacking.value(one, job) for one in plan.results}} for job in jobs]


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
    """Of the jobs, and of the points of the grid; with a line for each result that is lacking."""
    lacking = Lacking()
    rows = job_rows(plan, jobs, lacking)
    return pandas.DataFrame(rows), pandas.DataFrame(point_rows(plan, rows)), lacking.lines()


def units(plan, jobs):
    """Of each result, by the first job that has its table."""
    return {one.name: next((unit for job in jobs if (unit := unit_of(one, job.folder)) is not None), "") for one in plan.results}


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
