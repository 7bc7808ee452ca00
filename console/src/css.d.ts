/** Custom properties of style sheets may be given in `style`. */
import "react";

declare module "react" {
  interface CSSProperties {
    [property: `--${string}`]: string | number;
  }
}
