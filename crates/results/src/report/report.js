"use strict";
// Rows are kept in a list; only those that are wanted, and of them only the first few hundred, stand in the table.
document.documentElement.classList.add("js");
document.addEventListener("DOMContentLoaded", () => {
  const STEP = 200;
  const table = document.getElementById("all");
  const search = document.getElementById("search");
  const filter = document.getElementById("filter");
  const shown = document.getElementById("shown");
  const more = document.getElementById("more");
  const heads = [...table.tHead.rows[0].cells];
  const collator = new Intl.Collator(undefined, { numeric: true, sensitivity: "base" });
  const plain = (text) => text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();

  const rows = [...table.tBodies].map((body, order) => {
    const cells = body.rows[0].cells;
    return { body, cells, order, kinds: body.dataset.kinds.split(" "), text: plain(body.rows[0].textContent + " " + body.id.slice(2)) };
  });
  for (const row of rows) row.body.remove();
  table.classList.add("ready");

  let sorted = { column: -1, down: false };
  let wanted = rows;
  let limit = STEP;

  const value = (row) => {
    const cell = row.cells[sorted.column];
    return "value" in cell.dataset ? Number(cell.dataset.value) : cell.textContent.trim();
  };
  const compare = (one, other) => typeof one === "number" ? one - other : collator.compare(one, other);

  function sort() {
    if (sorted.column < 0) return;
    const keyed = rows.map((row) => [value(row), row]);
    const sign = sorted.down ? -1 : 1;
    keyed.sort((one, other) => sign * compare(one[0], other[0]) || one[1].order - other[1].order);
    rows.splice(0, rows.length, ...keyed.map((pair) => pair[1]));
  }

  function show() {
    const words = plain(search.value).split(/\s+/).filter(Boolean);
    const kind = filter.value;
    wanted = rows.filter((row) => (!kind || row.kinds.includes(kind)) && words.every((word) => row.text.includes(word)));
    for (const body of [...table.tBodies]) body.remove();
    table.append(...wanted.slice(0, limit).map((row) => row.body));
    const left = wanted.length - limit;
    more.hidden = left <= 0;
    more.textContent = `Show ${Math.min(left, STEP)} more`;
    const all = wanted.length === rows.length ? "" : ` of ${rows.length}`;
    shown.textContent = `${wanted.length}${all} students` + (left > 0 ? `, the first ${limit} shown` : "");
  }

  // Details stand in the page as text, already escaped, until they are opened.
  function open(body, wish) {
    const button = body.querySelector("button.open");
    const details = body.rows[1];
    const text = details.querySelector("script");
    if (text) {
      const content = document.createElement("div");
      content.innerHTML = text.textContent;
      text.replaceWith(content);
    }
    details.hidden = wish === undefined ? !details.hidden : !wish;
    button.setAttribute("aria-expanded", String(!details.hidden));
  }

  function follow() {
    const id = decodeURIComponent(location.hash.slice(1));
    const row = id.startsWith("r-") && rows.find((row) => row.body.id === id);
    if (!row) return;
    search.value = "";
    filter.value = "";
    limit = Math.max(limit, rows.indexOf(row) + 1);
    show();
    open(row.body, true);
    row.body.scrollIntoView();
    row.body.querySelector("button.open").focus({ preventScroll: true });
  }

  table.tHead.addEventListener("click", (event) => {
    const button = event.target.closest("button");
    if (!button) return;
    const column = heads.indexOf(button.closest("th"));
    // The first look at numbers is for the highest.
    const down = sorted.column === column ? !sorted.down : button.dataset.kind === "number";
    sorted = { column, down };
    heads.forEach((head, index) => {
      if (head.hasAttribute("aria-sort")) head.setAttribute("aria-sort", index !== column ? "none" : down ? "descending" : "ascending");
    });
    sort();
    show();
  });
  table.addEventListener("click", (event) => {
    const button = event.target.closest("button.open");
    if (button) open(button.closest("tbody"));
  });
  document.addEventListener("click", (event) => {
    const button = event.target.closest("button.find");
    const link = event.target.closest("a[href^='#r-']");
    if (button) {
      search.value = button.dataset.find;
      filter.value = "";
      limit = STEP;
      show();
      document.getElementById("students").scrollIntoView();
      search.focus({ preventScroll: true });
    } else if (link && link.hash === location.hash) {
      follow();
    }
  });
  search.addEventListener("input", () => { limit = STEP; show(); });
  filter.addEventListener("change", () => { limit = STEP; show(); });
  search.form.addEventListener("submit", (event) => event.preventDefault());
  more.addEventListener("click", () => { limit += STEP; show(); });
  addEventListener("hashchange", follow);
  show();
  follow();
});
