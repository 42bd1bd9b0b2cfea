// Makes the figures of a page interactive. Without this script, their static pictures stay.

import { breakingDistance } from "./breaking_distance";
import { pixelToRay } from "./pixel_to_ray";
import { projections } from "./projections";
import { sphereRoots } from "./sphere_roots";
import { triangleWeights } from "./triangle_weights";
import { walkSteps } from "./walk_steps";

const figures: Readonly<Record<string, (stage: HTMLElement) => void>> = {
    pixel_to_ray: pixelToRay,
    sphere_roots: sphereRoots,
    projections,
    triangle_weights: triangleWeights,
    breaking_distance: breakingDistance,
    walk_steps: walkSteps,
};

for (const figure of document.querySelectorAll<HTMLElement>("figure[data-figure]")) {
    const stage = figure.querySelector<HTMLElement>(".stage");
    const wake = figures[figure.dataset["figure"] ?? ""];
    if (stage !== null && wake !== undefined) {
        wake(stage);
        // In a figure, the arrow keys move a slider and must not turn to another chapter.
        figure.addEventListener("keydown", (event) => event.stopPropagation());
    }
}
