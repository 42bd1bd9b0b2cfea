// The figures' mathematics against Mitsuba's answers, each within its own tolerance, as
// the harness judges a submission. PINHOLE_PROBES names the file that `book check` writes.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { type Camera, type Ray, type Resolution, type Shape, intersect, viewingRay } from "../src/rays";

interface Probes {
    readonly shapes: readonly { readonly group: string; readonly shape: Shape; readonly ray: Ray; readonly min_t: number; readonly expected: readonly number[]; readonly allowed: readonly number[] }[];
    readonly rays: readonly { readonly group: string; readonly camera: Camera; readonly pixel: readonly [number, number]; readonly resolution: Resolution; readonly expected: readonly number[]; readonly allowed: readonly number[] }[];
}

const file = process.env["PINHOLE_PROBES"];
assert.ok(file !== undefined, "run it by: cargo pinhole book check --only interactive");
const probes = JSON.parse(readFileSync(file, "utf8")) as Probes;

const off = (got: readonly number[], expected: readonly number[], allowed: readonly number[]): boolean =>
    got.some((value, at) => !(Math.abs(Math.fround(value) - (expected[at] ?? NaN)) <= (allowed[at] ?? 0)));

test("the figures' rays are Mitsuba's", () => {
    assert.ok(probes.rays.length > 500);
    const wrong = probes.rays.filter(({ camera, pixel, resolution, expected, allowed }) => {
        const [i, j] = pixel;
        const ray = viewingRay(camera, { i, j }, resolution);
        return off([...ray.origin, ...ray.direction], expected, allowed);
    });
    assert.deepEqual(wrong.slice(0, 3), []);
});

test("the figures' intersections are Mitsuba's", () => {
    assert.ok(probes.shapes.length > 5000);
    const wrong = probes.shapes.filter(({ shape, ray, min_t, expected, allowed }) => {
        const met = intersect(shape, ray, min_t);
        // Any t and normal will do where nothing is to be hit.
        const channels = met === null || expected[0] === -1 ? 1 : 5;
        const got = met === null ? [-1] : [0, met.t, ...met.normal].slice(0, channels);
        return off(got, expected, allowed);
    });
    assert.deepEqual(wrong.slice(0, 3), []);
});
