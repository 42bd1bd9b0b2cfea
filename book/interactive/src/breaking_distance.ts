// A sphere that moves away while the lens zooms in, as three computations show it.

import facts from "./facts.json";
import { slider, table } from "./stage";

const { side, ways } = facts.breaking_distance;
const NAMES: Readonly<Record<string, string>> = {
    f32: "quadratic formula, f32",
    f64: "quadratic formula, f64",
    foot: "Pythagorean form, f64",
};

const rgb = (hex: string): readonly number[] => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

export function breakingDistance(stage: HTMLElement): void {
    const row = document.createElement("div");
    row.className = "silhouettes";
    row.setAttribute("aria-hidden", "true");
    const canvases = ways.map(({ way }) => {
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [side, side];
        const column = document.createElement("div");
        column.append(NAMES[way] ?? way, canvas);
        row.append(column);
        return canvas;
    });
    const distance = slider("distance / radius, as a power of ten", [1, 12, 0.5], 8, () => draw());
    const numbers = table();
    const [inside, outside] = [rgb(facts.colours[1] ?? "#ffffff"), rgb(facts.background)];

    function draw(): void {
        const told = ways.map(({ way, pictures }, number) => {
            const { pixels, wrong } = pictures[2 * (distance.value - 1)] ?? { pixels: "", wrong: 0 };
            const picture = new ImageData(side, side);
            for (let at = 0; at < side * side; at += 1) {
                const four = parseInt(pixels.charAt(at >> 2), 16);
                const met = ((four >> (3 - (at % 4))) & 1) === 1;
                picture.data.set([...(met ? inside : outside), 255], 4 * at);
            }
            canvases[number]?.getContext("2d")?.putImageData(picture, 0, 0);
            return [NAMES[way] ?? way, `${wrong} wrong pixels`] as const;
        });
        numbers.show([["distance", (10 ** distance.value).toPrecision(3)], ...told]);
    }
    stage.replaceChildren(row, distance.row, numbers.element);
    draw();
}
