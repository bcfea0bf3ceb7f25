"""Runs a program with one fault in each run: what memory.py and programs.py share.

A run of theirs has the exit code as `code`, the messages as `err`, the lines that say where the
fault was as `place`, what else is to be said of its end as `note`, and problem(good), which returns
what is wrong with it in comparison with a run without a fault, or "".
"""

import collections
import concurrent.futures
import os
import sys

STEP = int(os.environ.get("LIMN_FAULTS_ALL", "0"))  # 0 = a sample


def try_numbers(title, what, numbers, count, run, good):
    """Calls run(number) for each, prints how the runs ended, and returns whether all ended well."""
    ends = collections.Counter()
    problems = {}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for number, ended in zip(numbers, pool.map(run, numbers)):
            problem = ended.problem(good)
            ends[(problem or "exit code " + str(ended.code)) + ended.note] += 1
            if problem:
                problems.setdefault((problem, *ended.place), []).append((number, ended.err))
    print(f"{title}: {len(numbers)} of {count} {what}s fail:",
          "; ".join(f"{times} times {end}" for end, times in ends.most_common()), flush=True)
    for (problem, *place), runs in problems.items():
        number, err = runs[0]
        print(f"  {title}: {problem}, {len(runs)} times, first of {what} {number}:",
              err[-400:].strip(), *place[:14], sep="\n      ", flush=True)
    return not problems


def main(cases, try_case):
    """Tries each case, and ends the program with 1 if one of them has a problem."""
    sys.exit(0 if all([try_case(case) for case in cases]) else 1)
