//! Programs that are opened as what they cut.

use crate::shop::Shop;

/// A box of 4 by 3, which tests the unit as part files do: 0 is inches.
fn boxed(unit: u8) -> String {
    let (size, speed) = if unit == 0 { ("4", "3,1") } else { ("40", "30,5") };
    format!(
        "IF %(25)={} THEN GOTO UNIT_ERROR\nVS,{speed}\nJ2,0,0\nMZ,-.1\nMX,{size}\nMY,{size}\nMX,0\nMY,0\nJZ,1\nEND\n\
         UNIT_ERROR:\nMSGBOX (\"wrong unit\")\nEND\n",
        1 - unit
    )
}

/// Extent of the drawing in X.
fn width(shop: &Shop, file: &str) -> f64 {
    let did = shop.kerf(&format!("draw {file} --list"));
    did.exits(0);
    let far = |shape: &serde_json::Value| shape["bounds"]["max"]["x"].as_f64().unwrap();
    did.events().iter().map(far).fold(0.0, f64::max)
}

#[test]
fn a_part_file_is_opened_in_the_unit_in_which_it_runs() {
    let (inches, metric) = (boxed(0), boxed(1));
    let files = [("in.sbp", inches.as_str()), ("mm.sbp", &metric), ("plain.sbp", "MX,2\nMY,1\n")];
    let shop = Shop::new(&files);
    assert!((width(&shop, "in.sbp") - 101.6).abs() < 1e-4, "{}", width(&shop, "in.sbp"));
    assert!((width(&shop, "mm.sbp") - 40.0).abs() < 1e-4, "{}", width(&shop, "mm.sbp"));
    shop.kerf("draw mm.sbp -o z.rsg").exits(0).complains("read in millimetres");
    assert!((width(&shop, "plain.sbp") - 50.8).abs() < 1e-4);
    assert!((width(&shop, "plain.sbp --units mm") - 2.0).abs() < 1e-4);
    shop.kerf("draw in.sbp --units mm -o z.rsg").exits(1).complains("cuts nothing");
    for (units, far) in [("", 50.8), ("--units in", 50.8), ("--units mm", 2.0)] {
        shop.kerf(&format!("toolpath plain.sbp {units} -o p.rsm --report")).exits(0);
        assert!((width(&shop, "p.rsm") - far).abs() < 1e-4, "{units}");
        shop.kerf(&format!("toolpath plain.sbp {units} -o p.nc --report")).exits(0);
    }
}
