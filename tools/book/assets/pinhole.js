// Whatever is wider than the page scrolls on its own, so the keyboard must be able to reach it.
const reachable = () => {
    for (const element of document.querySelectorAll(".formula, .table-wrapper, pre code, figure")) {
        if (element.scrollWidth > element.clientWidth) {
            element.tabIndex = 0;
        } else {
            element.removeAttribute("tabindex");
        }
    }
};
addEventListener("load", reachable);
addEventListener("resize", reachable);

// Unfold everything before printing, and fold it again afterwards.
let opened = [];
addEventListener("beforeprint", () => {
    opened = [...document.querySelectorAll("details:not([open])")];
    opened.forEach((one) => (one.open = true));
});
addEventListener("afterprint", () => opened.forEach((one) => (one.open = false)));

// mdBook's sidebar switch is a label. For the keyboard and for screen readers,
// make it the button that it looks like.
const sidebarSwitch = document.getElementById("mdbook-sidebar-toggle");
if (sidebarSwitch !== null) {
    sidebarSwitch.setAttribute("role", "button");
    sidebarSwitch.tabIndex = 0;
    sidebarSwitch.addEventListener("keydown", (event) => {
        if (event.key === "Enter" || event.key === " ") {
            event.preventDefault();
            sidebarSwitch.click();
        }
    });
}
