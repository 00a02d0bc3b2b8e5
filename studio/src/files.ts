// Files that the page gives away.

/** The text of base64. */
export function decoded(content: string): string {
  return new TextDecoder().decode(bytes(content));
}

export function bytes(content: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(content), (c) => c.charCodeAt(0));
}

/** Hands a file to the browser. */
export function give(name: string, content: BlobPart): void {
  const address = URL.createObjectURL(new Blob([content]));
  const link = Object.assign(document.createElement("a"), { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}
