// A click loads that asset's file, a script next to the page: a page from a disk may load no other.
const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const get = (id) => document.getElementById(id);
const viewer = document.querySelector("model-viewer"), dialog = get("shown");
const lights = JSON.parse(get("lights").textContent);
const [rows, columns] = [@rows@, @columns@];
let model = null, wanted = null;

function relight() {
  const head = `#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${rows} +X ${columns}\n`;
  // By the ending the viewer knows that it is a high dynamic range.
  viewer.environmentImage = URL.createObjectURL(new Blob([head, bytes(lights[get("light").value])])) + "#.hdr";
}

// Called by the asset's script.
window.showAsset = (folder, glb) => {
  if (folder !== wanted) return;
  if (model) URL.revokeObjectURL(model);
  model = URL.createObjectURL(new Blob([bytes(glb)], { type: "model/gltf-binary" }));
  viewer.src = model;
};

function open(button) {
  wanted = button.dataset.folder;
  get("name").textContent = button.dataset.name;
  document.body.dataset.loaded = "";
  dialog.showModal();
  const script = document.createElement("script");
  script.src = "contact_sheet/" + encodeURIComponent(button.dataset.file) + ".js";
  script.onload = () => script.remove();
  script.onerror = () => { get("name").textContent = "The file of this asset is not next to the page."; };
  document.head.append(script);
}

customElements.whenDefined("model-viewer").then((Viewer) => {
  const type = Viewer || customElements.get("model-viewer");
  for (const name of ["dracoDecoderLocation", "ktx2TranscoderLocation", "lottieLoaderLocation"])
    type[name] = "data:,";
  relight();
});
for (const button of document.querySelectorAll("figure button"))
  button.addEventListener("click", () => open(button));
viewer.addEventListener("load", () => { document.body.dataset.loaded = "asset"; });
viewer.addEventListener("error", (event) => { document.body.dataset.loaded = "error: " + JSON.stringify(event.detail); });
get("light").addEventListener("change", relight);
get("exposure").addEventListener("input", (event) => { viewer.exposure = event.target.value; });
get("spin").addEventListener("change", (event) => { viewer.autoRotate = event.target.checked; });
get("close").addEventListener("click", () => dialog.close());
dialog.addEventListener("close", () => { wanted = null; });
// contact_sheet.html#FOLDER opens with that asset.
const first = decodeURIComponent(location.hash.slice(1));
for (const button of document.querySelectorAll("figure button"))
  if (button.dataset.folder === first) open(button);
