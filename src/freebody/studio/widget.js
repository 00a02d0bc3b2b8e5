// Shows the page of the studio in a cell of a notebook, in a frame of its own: neither sees the other's styles, keys or
// storage. What the page asks goes to the kernel and the answer back; the text is the same on all sides.
function render({ model, el }) {
  const frame = document.createElement("iframe");
  frame.title = model.get("title");
  frame.setAttribute("sandbox", "allow-scripts");
  frame.style.cssText = `width: 100%; height: ${model.get("height")}; border: 0`;
  let isOwn = false; // whether the text is just being changed by this page
  const say = (document) => frame.contentWindow?.postMessage(document, "*");
  const hear = (event) => {
    if (event.source !== frame.contentWindow) return;
    const { text } = event.data;
    if (text === undefined) return model.send(event.data);
    isOwn = true;
    model.set("text", text);
    isOwn = false;
    model.save_changes();
  };
  const answered = (reply) => say(reply);
  const changed = () => isOwn || say({ text: model.get("text") });
  addEventListener("message", hear);
  model.on("msg:custom", answered);
  model.on("change:text", changed);
  frame.srcdoc = model.get("page");
  el.append(frame);
  return () => {
    removeEventListener("message", hear);
    model.off("msg:custom", answered);
    model.off("change:text", changed);
  };
}
export default { render };
