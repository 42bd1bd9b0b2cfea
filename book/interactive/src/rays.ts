// The figures' mathematics: the harness's words, and the chapters' formulas. Tested
// against the goldens of the probes (test/probes.test.ts).

export type Vec = readonly [number, number, number];

export interface Ray {
    readonly origin: Vec;
    readonly direction: Vec;
}

export interface Intersection {
    readonly t: number;
    readonly normal: Vec;
}

export interface Sphere {
    readonly center: Vec;
    readonly radius: number;
}

export interface Plane {
    readonly point: Vec;
    readonly normal: Vec;
}

export interface Triangle {
    readonly corners: readonly [Vec, Vec, Vec];
}

// As the harness's `Shape` is written to JSON.
export type Shape =
    | { readonly Sphere: Sphere }
    | { readonly Plane: Plane }
    | { readonly Triangle: Triangle };

export interface Camera {
    readonly eye: Vec;
    readonly u: Vec;
    readonly v: Vec;
    readonly w: Vec;
    readonly width: number;
    readonly height: number;
    readonly projection: "Orthographic" | { readonly Perspective: { readonly focal_length: number } };
}

export interface Pixel {
    readonly i: number;
    readonly j: number;
}

export interface Resolution {
    readonly n_x: number;
    readonly n_y: number;
}

export const add = (a: Vec, b: Vec): Vec => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec, by: number): Vec => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Vec): number => Math.sqrt(dot(a, a));
export const cross = (a: Vec, b: Vec): Vec => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
];
export const at = (ray: Ray, t: number): Vec => add(ray.origin, scale(ray.direction, t));
const unit = (a: Vec): Vec => scale(a, 1 / length(a));

// Where a place in pixel space lies on an image plane of this width (or height).
export const onPlane = (place: number, width: number, pixels: number): number =>
    (width / pixels) * place - width / 2;

export function viewingRay(camera: Camera, pixel: Pixel, resolution: Resolution): Ray {
    const right = scale(camera.u, onPlane(pixel.i + 0.5, camera.width, resolution.n_x));
    const up = scale(camera.v, onPlane(pixel.j + 0.5, camera.height, resolution.n_y));
    const inPlane = add(right, up);
    if (camera.projection === "Orthographic") {
        return { origin: add(camera.eye, inPlane), direction: scale(camera.w, -1) };
    }
    const forward = scale(camera.w, -camera.projection.Perspective.focal_length);
    return { origin: camera.eye, direction: add(inPlane, forward) };
}

// a t² + 2 h t + k = 0.
export interface Quadratic {
    readonly a: number;
    readonly h: number;
    readonly k: number;
    readonly discriminant: number;
    // t₀ ≤ t₁; none if the line misses.
    readonly roots: readonly [number, number] | null;
}

export function quadratic(ray: Ray, sphere: Sphere): Quadratic {
    const m = sub(ray.origin, sphere.center);
    const a = dot(ray.direction, ray.direction);
    const h = dot(ray.direction, m);
    const k = dot(m, m) - sphere.radius * sphere.radius;
    const discriminant = h * h - a * k;
    const root = Math.sqrt(discriminant);
    const roots = discriminant < 0 ? null : ([(-h - root) / a, (-h + root) / a] as const);
    return { a, h, k, discriminant, roots };
}

// Which of the two counts: 0, 1, or none.
export function countingRoot(roots: Quadratic["roots"], minT: number): 0 | 1 | null {
    if (roots === null || roots[1] < minT) {
        return null;
    }
    return roots[0] >= minT ? 0 : 1;
}

function meetSphere(sphere: Sphere, ray: Ray, minT: number): Intersection | null {
    const { roots } = quadratic(ray, sphere);
    const counts = countingRoot(roots, minT);
    if (roots === null || counts === null) {
        return null;
    }
    const t = roots[counts];
    return { t, normal: scale(sub(at(ray, t), sphere.center), 1 / sphere.radius) };
}

function meetPlane(plane: Plane, ray: Ray, minT: number): Intersection | null {
    const step = dot(ray.direction, plane.normal);
    const t = dot(sub(plane.point, ray.origin), plane.normal) / step;
    return step !== 0 && t >= minT ? { t, normal: unit(plane.normal) } : null;
}

// e + t d = a + α t₁ + β t₂, by Cramer's rule.
export interface Weights {
    readonly alpha: number;
    readonly beta: number;
    readonly t: number;
}

export function weights({ corners: [a, b, c] }: Triangle, ray: Ray): Weights {
    const [t1, t2, s] = [sub(b, a), sub(c, a), sub(ray.origin, a)];
    const [p, q] = [cross(ray.direction, t2), cross(s, t1)];
    const determinant = dot(t1, p);
    return { alpha: dot(s, p) / determinant, beta: dot(ray.direction, q) / determinant, t: dot(t2, q) / determinant };
}

function meetTriangle(triangle: Triangle, ray: Ray, minT: number): Intersection | null {
    const { alpha, beta, t } = weights(triangle, ray);
    const inside = alpha >= 0 && beta >= 0 && alpha + beta <= 1;
    const [a, b, c] = triangle.corners;
    return inside && t >= minT ? { t, normal: unit(cross(sub(b, a), sub(c, a))) } : null;
}

export function intersect(shape: Shape, ray: Ray, minT: number): Intersection | null {
    if ("Sphere" in shape) {
        return meetSphere(shape.Sphere, ray, minT);
    }
    return "Plane" in shape
        ? meetPlane(shape.Plane, ray, minT)
        : meetTriangle(shape.Triangle, ray, minT);
}

export interface Hit {
    readonly object: number;
    readonly intersection: Intersection;
}

export function firstHit(shapes: readonly Shape[], ray: Ray, minT: number): Hit | null {
    let first: Hit | null = null;
    shapes.forEach((shape, object) => {
        const met = intersect(shape, ray, minT);
        if (met !== null && (first === null || met.t < first.intersection.t)) {
            first = { object, intersection: met };
        }
    });
    return first;
}
