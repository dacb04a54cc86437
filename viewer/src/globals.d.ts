/** What build.js puts in place of these names. */
declare const SHADERS: string;
declare const DIGEST: string;
declare const EXPLORABLES: string;
declare const STYLES: string;
declare const VIEWER: string;

interface Navigator {
  /** Not in all browsers. */
  connection?: { saveData: boolean };
}
