// Finds what `entries` (entries.js) names: [kind, name, address]. "/" leads to the field, the arrow
// keys through what is found.
const field = document.getElementById("search");
const found = document.getElementById("found");
const most = 30;

/// Names that begin with the words come first, then those that hold them.
function matches(words) {
  const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
  if (wanted.length === 0) return [];
  const rank = (name) => {
    const lower = name.toLowerCase();
    if (!wanted.every((word) => lower.includes(word))) return -1;
    return lower === wanted[0] ? 0 : lower.startsWith(wanted[0]) ? 1 : 2;
  };
  return entries.map((entry) => [rank(entry[1]), entry]).filter(([r]) => r >= 0)
    .sort((a, b) => a[0] - b[0]).slice(0, most).map(([, entry]) => entry);
}

function show() {
  found.replaceChildren(...matches(field.value).map(([kind, name, address]) => {
    const link = document.createElement("a");
    link.href = address;
    link.append(name, Object.assign(document.createElement("small"), { textContent: kind }));
    const item = document.createElement("li");
    item.append(link);
    return item;
  }));
  found.hidden = found.childElementCount === 0;
}

function move(step) {
  const links = [field, ...found.querySelectorAll("a")];
  const next = links.indexOf(document.activeElement) + step;
  links[Math.max(0, Math.min(next, links.length - 1))].focus();
}

field.addEventListener("input", show);
field.addEventListener("focus", show);
document.addEventListener("click", (event) => {
  if (!event.target.closest(".search")) found.hidden = true;
});
document.addEventListener("keydown", (event) => {
  const inside = document.activeElement.closest(".search");
  if (event.key === "/" && !inside) {
    field.focus();
  } else if (event.key === "Escape" && inside) {
    found.hidden = true;
    document.activeElement.blur();
  } else if (event.key === "Enter" && document.activeElement === field) {
    found.querySelector("a")?.click();
  } else if (inside && (event.key === "ArrowDown" || event.key === "ArrowUp")) {
    move(event.key === "ArrowDown" ? 1 : -1);
  } else {
    return;
  }
  event.preventDefault();
});
