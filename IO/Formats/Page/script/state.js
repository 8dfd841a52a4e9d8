// What all parts of the script share: the elements of the page, what the writer says of its data, and
// what is shown.
const element = (id) => document.getElementById(id);
const description = JSON.parse(element("description").textContent);
const views = {};
let THREE, mesh, renderer, picked = null, isWaiting = false;
