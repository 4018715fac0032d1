// The asset from the page's own bytes, and its light: texels from the page, turned by columns.
const bytes = (id) => Uint8Array.from(atob(document.getElementById(id).textContent), (c) => c.charCodeAt(0));
const viewer = document.querySelector("model-viewer");
const lights = JSON.parse(document.getElementById("lights").textContent);
const [rows, columns] = [@rows@, @columns@];
const light = document.getElementById("light"), turn = document.getElementById("turn");
let shown = null;
// report.html#studio opens with that light.
const wanted = decodeURIComponent(location.hash.slice(1));
if (wanted in lights) light.value = wanted;

function relight() {
  const texels = Uint8Array.from(atob(lights[light.value]), (c) => c.charCodeAt(0));
  const turned = new Uint8Array(texels.length), by = Math.round((turn.value / 360) * columns);
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const from = 4 * (row * columns + ((column + by) % columns));
      turned.set(texels.subarray(from, from + 4), 4 * (row * columns + column));
    }
  const head = `#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${rows} +X ${columns}\n`;
  const old = shown;
  shown = URL.createObjectURL(new Blob([head, turned]));
  // By the ending the viewer knows that it is a high dynamic range.
  viewer.environmentImage = shown + "#.hdr";
  if (old) setTimeout(() => URL.revokeObjectURL(old), 5000);
}

// Nothing of the viewer may look for a network: the asset needs none of these decoders.
customElements.whenDefined("model-viewer").then((Viewer) => {
  const type = Viewer || customElements.get("model-viewer");
  for (const name of ["dracoDecoderLocation", "ktx2TranscoderLocation", "lottieLoaderLocation"])
    type[name] = "data:,";
  relight();
  viewer.src = URL.createObjectURL(new Blob([bytes("glb")], { type: "model/gltf-binary" }));
});
viewer.addEventListener("load", () => { document.body.dataset.loaded = "asset"; });
viewer.addEventListener("error", (event) => { document.body.dataset.loaded = "error: " + JSON.stringify(event.detail); });
light.addEventListener("change", relight);
turn.addEventListener("input", relight);
document.getElementById("exposure").addEventListener("input", (event) => { viewer.exposure = event.target.value; });
document.getElementById("spin").addEventListener("change", (event) => { viewer.autoRotate = event.target.checked; });
