/** Screens on which the page is looked at, and the themes that it wears there. */

export const phone = { width: 390, height: 844 };
export const tablet = { width: 800, height: 1280 };
export const sizes = [
  phone,
  tablet,
  { width: 1024, height: 768 },
  { width: 1440, height: 900 },
  { width: 1920, height: 1080 },
];

export const themes = ["light", "dark", "contrast"];
