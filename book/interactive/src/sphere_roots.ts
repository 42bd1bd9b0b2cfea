// A ray moved across a sphere: the discriminant, both roots, and the part of the ray that
// min_t leaves. It doesn't say which root counts: readers find that out themselves.

import facts from "./facts.json";
import { WIDTH, circle, clamped, drawing, line, slider, table, word } from "./stage";
import { shown } from "./words";

const { start, most, a, h, stride, ahead, radius } = facts.sphere_roots;
const positions = facts.sphere_roots.positions as readonly {
    readonly distance: number;
    readonly k: number;
    readonly discriminant: number;
    readonly roots: readonly [number, number] | null;
}[];

// The drawing's y is the distance from the centre, downward.
const [HEIGHT, SCALE] = [252, 48];
const [EYE_X, CENTER_Y] = [22, 122];
const LAST_MIN_T = 3;

export function sphereRoots(stage: HTMLElement): void {
    const spacing = (positions[most + 1]?.distance ?? 1) - (positions[most]?.distance ?? 0);
    const svg = drawing(HEIGHT, (_, y) => {
        step.value = clamped(Math.round((y - CENTER_Y) / SCALE / spacing), -most, most);
        draw();
    });
    const step = slider("move the ray", [-most, most, 1], start, () => draw());
    const minT = slider("min_t", [0, LAST_MIN_T, 0.01], 1, () => draw());
    const numbers = table();
    const x = (t: number): number => EYE_X + SCALE * stride * t;

    function draw(): void {
        const position = positions[step.value + most];
        if (position === undefined) {
            return;
        }
        const { distance, k, discriminant, roots } = position;
        const y = CENTER_Y + SCALE * distance;
        const from = x(minT.value);
        const ends = (roots ?? []).flatMap((t, number) => [
            circle([x(t), y], 6, "none"),
            word([x(t) + (number === 0 ? -14 : 14), y - 10], number === 0 ? "t₀" : "t₁"),
        ]);
        svg.replaceChildren(
            circle([x(0) + SCALE * ahead, CENTER_Y], SCALE * radius, "#56b4e9", 0.3),
            line([x(0), y], [from, y], "currentColor", 1, "5 4"),
            line([from, y], [WIDTH - 2, y], "#d55e00", 2.5),
            line([from, y - 12], [from, y + 12], "#0072b2", 4),
            word([clamped(from, 26, WIDTH - 26), y + 28], "min_t"),
            circle([x(0), y], 4, "currentColor"),
            word([x(0), y - 10], "e"),
            ...ends,
        );
        numbers.show([
            ["distance", shown(distance)],
            ["a", shown(a)],
            ["h", shown(h)],
            ["k", shown(k)],
            ["Δ", shown(discriminant)],
            ["t₀, t₁", roots === null ? "none: Δ < 0" : roots.map(shown).join(", ")],
            ["min_t", shown(minT.value)],
        ]);
    }
    stage.replaceChildren(svg, step.row, minT.row, numbers.element);
    draw();
}
