#!/usr/bin/env python3
"""Hand-wheel positions of scripts, lessons and exercises after the brake's new law.

Old: grip share = p. New: grip share = ((p - p0) / (1 - p0))^n with p0 = 0.4, n = 2.5, so
p_new = p0 + (1 - p0) p^(1/n); 0 stays 0 and 1 stays 1.

  brake_positions.py [--check] [FILE...]      without files: config/scripts/*.json and config/exercises/*.json

What it changes, and nothing else:
- "brake": p with 0 < p < 1                        the same grip
- "brake": 0 in a script whose next order of the brake is a partial one (0 < p < 1), or that comes after a partial
  one: 0.4, the lining just clear of the drum. A hand that eases and is about to check again does not spin the wheel
  two turns away from the lining; the grip is the same, none.
- "brake_position": {"below": p} with 0 < p <= 0.5 the same grip
What it leaves: {"above": p} and {"below": 0.9}: "hard on" is a place of the wheel, not a grip.

A file that has been through it is known by its figures (any position that only this script writes) and skipped; --force
converts it all the same.
"""
import re, sys, glob

P0, N = 0.4, 2.5
OLD = [0.003, 0.004, 0.005, 0.006, 0.0075, 0.008, 0.009, 0.01, 0.011, 0.012, 0.015, 0.02, 0.03, 0.05, 0.06, 0.1,
       0.15, 0.2, 0.3, 0.4, 0.5, 0.6]


def new(p):
    return p if p in (0, 1) else round(P0 + (1 - P0) * p ** (1 / N), 4)


IMAGES = {new(p) for p in OLD}
BRAKE = re.compile(r'("brake"\s*:\s*)([0-9.]+)')
BELOW = re.compile(r'("brake_position"\s*:\s*\{\s*"below"\s*:\s*)([0-9.]+)')


def convert(text, script):
    orders = [(m.start(), float(m.group(2))) for m in BRAKE.finditer(text)]
    eased = set()
    if script:
        for k, (at, p) in enumerate(orders):
            before = orders[k - 1][1] if k > 0 else 1
            after = orders[k + 1][1] if k + 1 < len(orders) else 0
            if p == 0 and after > 0 and (0 < after < 1 or 0 < before < 1):
                eased.add(at)

    def brake(m):
        p = float(m.group(2))
        if m.start() in eased:
            return m.group(1) + f'{P0:g}'
        return m.group(1) + (f'{new(p):g}' if 0 < p < 1 else m.group(2))

    def below(m):
        p = float(m.group(2))
        return m.group(1) + (f'{new(p):g}' if 0 < p <= 0.5 else m.group(2))

    return BELOW.sub(below, BRAKE.sub(brake, text))


def main():
    arguments = sys.argv[1:]
    check, force = '--check' in arguments, '--force' in arguments
    files = [a for a in arguments if not a.startswith('--')] or sorted(
        glob.glob('config/scripts/*.json') + glob.glob('config/exercises/*.json'))
    for file in files:
        text = open(file).read()
        values = {float(m.group(2)) for r in (BRAKE, BELOW) for m in r.finditer(text)}
        if values & IMAGES and not force:
            stray = sorted(v for v in values if 0 < v < P0)
            print(f'{file}: has been converted, skipped' + (f'; LOOK AT {stray}' if stray else ''))
            continue
        changed = convert(text, '/scripts/' in file or '"steps"' in text)
        if changed == text:
            continue
        for before, after in zip(text.splitlines(), changed.splitlines()):
            if before != after:
                print(f'{file}: {before.strip()[:150]}\n    -> {after.strip()[:150]}')
        if not check:
            open(file, 'w').write(changed)


main()
