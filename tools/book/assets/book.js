// What is wider than the page scrolls on its own; then the keyboard must reach it.
const reachable = () => {
    for (const element of document.querySelectorAll(".formula, .table-wrapper, pre code")) {
        if (element.scrollWidth > element.clientWidth) {
            element.tabIndex = 0;
        } else {
            element.removeAttribute("tabindex");
        }
    }
};
addEventListener("load", reachable);
addEventListener("resize", reachable);
