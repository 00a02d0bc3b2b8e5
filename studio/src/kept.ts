// What the browser keeps: choices and drafts. In one that keeps nothing they last as long as the page.

class Kept {
  constructor(private readonly storage: () => Storage) {}

  get(key: string): string | null {
    try {
      return this.storage().getItem(`freebody.${key}`);
    } catch {
      return null;
    }
  }
  /** Null takes it out. */
  set(key: string, value: string | null): void {
    try {
      if (value === null) this.storage().removeItem(`freebody.${key}`);
      else this.storage().setItem(`freebody.${key}`, value);
    } catch {
      // there is no room, or keeping is not allowed
    }
  }
  /** The keys that begin so. */
  keys(beginning: string): string[] {
    try {
      return Object.keys(this.storage()).filter((key) => key.startsWith(`freebody.${beginning}`)).map((key) => key.slice("freebody.".length));
    } catch {
      return [];
    }
  }
}

/** For all windows, and for the next time. */
export const kept = new Kept(() => localStorage);
/** For this window, as long as it is open: also when the page is loaded anew. */
export const keptByWindow = new Kept(() => sessionStorage);
