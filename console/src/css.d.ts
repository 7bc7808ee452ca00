/** Custom properties of style sheets may be given in `style`. */
import "react";

declare module "react" {
  interface CSSProperties {
    [property: `--${string}`]: string | number;
  }
}

/** Text files as they are. */
declare module "*?raw" {
  const text: string;
  // biome-ignore lint/style/noDefaultExport: that is how Vite gives them
  export default text;
}
