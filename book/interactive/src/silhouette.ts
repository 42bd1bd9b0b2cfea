// One sphere from afar, decided in three ways: tools/book/src/silhouette.rs, again. That
// both count the same wrong pixels is tested (test/silhouette.test.ts).

export type Meets = (x: number, y: number, far: number) => boolean;

// Pixels of a silhouette's side, and the middle of one, from −1.2 to 1.2 radii.
export const SIDE = 40;
export const on = (k: number): number => ((k + 0.5) / SIDE) * 2.4 - 1.2;

type Rounding = (value: number) => number;
type Vec = readonly [number, number, number];

const AXIS: Vec = [0.36, 0.48, 0.8];
const RIGHT: Vec = [0.8, -0.6, 0];
const UP: Vec = [0.48, 0.64, -0.6];

const each = (one: (k: 0 | 1 | 2) => number): Vec => [one(0), one(1), one(2)];
const dot = (a: Vec, b: Vec, to: Rounding): number => to(to(to(a[0] * b[0]) + to(a[1] * b[1])) + to(a[2] * b[2]));

// The direction d, and m = e − c; e is the origin.
function posed(x: number, y: number, far: number, to: Rounding): readonly [Vec, Vec] {
    const center = each((k) => to(far * AXIS[k]));
    return [each((k) => to(center[k] + x * RIGHT[k] + y * UP[k])), each((k) => -center[k])];
}

// The textbook's discriminant, every operation rounded in this way.
const textbook =
    (to: Rounding): Meets =>
    (x, y, far) => {
        const [d, m] = posed(x, y, far, to);
        const [a, h, k] = [dot(d, d, to), dot(d, m, to), to(dot(m, m, to) - 1)];
        return to(to(h * h) - to(a * k)) >= 0;
    };

const asItIs: Rounding = (value) => value;

// From the foot of the perpendicular (Haines, Günther & Akenine-Möller 2019).
const fromTheFoot: Meets = (x, y, far) => {
    const [d, m] = posed(x, y, far, asItIs);
    const along = dot(d, m, asItIs) / dot(d, d, asItIs);
    const foot = each((k) => m[k] - along * d[k]);
    return 1 - dot(foot, foot, asItIs) >= 0;
};

export const WAYS = { f32: textbook(Math.fround), f64: textbook(asItIs), foot: fromTheFoot } as const;

// The picture, row by row from the top.
export function silhouette(meets: Meets, far: number): boolean[] {
    return Array.from({ length: SIDE * SIDE }, (_, at) => meets(on(at % SIDE), on(Math.floor(at / SIDE)), far));
}

export function wrong(meets: Meets, far: number): number {
    const truth: Meets = (x, y) => (x * x + y * y) * (1 - 1 / (far * far)) <= 1;
    const right = silhouette(truth, far);
    return silhouette(meets, far).filter((met, at) => met !== right[at]).length;
}
