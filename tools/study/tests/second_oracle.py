"""A second oracle for the study, with Python's fractions and decimals.

Reads a question on each line, a shape's name and the bits of its numbers, and answers with
`miss`, or t as a fraction with a hundred correct digits.
"""

import struct
import sys
from decimal import Decimal, localcontext
from fractions import Fraction

DIGITS = 120


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def determinant(a, b, c):
    """The determinant of the matrix with these columns, by Sarrus's rule."""
    return (a[0] * b[1] * c[2] + b[0] * c[1] * a[2] + c[0] * a[1] * b[2]
            - c[0] * b[1] * a[2] - b[0] * a[1] * c[2] - a[0] * c[1] * b[2])


def decimal(fraction):
    return Decimal(fraction.numerator) / Decimal(fraction.denominator)


def sphere(numbers):
    """By the distance along the line from its point nearest to the centre."""
    center, radius, origin, direction, min_t = (
        numbers[0:3], numbers[3], numbers[4:7], numbers[7:10], numbers[10])
    length = dot(direction, direction)
    nearest = dot(minus(center, origin), direction) / length
    foot = [e + nearest * d for e, d in zip(origin, direction)]
    apart = minus(foot, center)
    half_chord = (radius * radius - dot(apart, apart)) / length
    if half_chord < 0:
        return None
    # nearest - h >= min_t and nearest + h >= min_t, with h the root of half_chord.
    beyond = nearest - min_t
    if beyond >= 0 and beyond * beyond >= half_chord:
        sign, other = -1, nearest * nearest - half_chord
    elif beyond >= 0 or beyond * beyond <= half_chord:
        sign, other = 1, nearest * nearest - half_chord
    else:
        return None
    root = decimal(half_chord).sqrt()
    if (nearest > 0) == (sign > 0) or nearest == 0:
        return decimal(nearest) + sign * root
    # The product of both roots, so that nothing cancels.
    return decimal(other) / (decimal(nearest) - sign * root)


def plane(numbers):
    point, normal, origin, direction, min_t = (
        numbers[0:3], numbers[3:6], numbers[6:9], numbers[9:12], numbers[12])
    along = dot(normal, direction)
    if along == 0:
        return None
    t = (dot(normal, point) - dot(normal, origin)) / along
    return decimal(t) if t >= min_t else None


def triangle(numbers):
    a, b, c = numbers[0:3], numbers[3:6], numbers[6:9]
    origin, direction, min_t = numbers[9:12], numbers[12:15], numbers[15]
    columns = minus(b, a), minus(c, a), [-x for x in direction]
    whole = determinant(*columns)
    if whole == 0:
        return None
    right = minus(origin, a)
    alpha = determinant(right, columns[1], columns[2]) / whole
    beta = determinant(columns[0], right, columns[2]) / whole
    t = determinant(columns[0], columns[1], right) / whole
    if alpha < 0 or beta < 0 or alpha + beta > 1 or t < min_t:
        return None
    return decimal(t)


def main():
    shapes = {"sphere": sphere, "plane": plane, "triangle": triangle}
    with localcontext() as context:
        context.prec, context.Emax, context.Emin = DIGITS, 10**9, -(10**9)
        for line in sys.stdin:
            shape, *numbers = line.split()
            floats = struct.unpack(f">{len(numbers)}d", bytes.fromhex("".join(numbers)))
            t = shapes[shape]([Fraction(number) for number in floats])
            print("miss" if t is None else Fraction(t))


if __name__ == "__main__":
    main()
