//! Saved machines keep their controller: the name alone drives it.

use crate::bench::Bench;
use crate::close;
use crate::shop::Shop;

#[test]
fn a_saved_machine_is_driven_by_its_name() {
    let (shop, bench) = (Shop::new(&[("there.sbp", "MS,2\nMX,1\n")]), Bench::new(&[]));
    shop.kerf(&format!("machine save shop --machine grbl:{}", bench.port)).exits(0);
    // Who looks at its settings, or at a program, opens no port.
    shop.kerf("get options.controller --machine shop").exits(0).says(&bench.port);
    let check = shop.kerf("check there.sbp --machine shop");
    check.exits(0);
    assert!(!check.err().contains("grbl"), "{}", check.err());
    assert!(bench.look(|fake| fake.lines.clone()).is_empty());
    shop.kerf("run there.sbp --machine shop").exits(0).complains("grbl 1.1h");
    bench.until(|fake| close(fake.position().0[0], 25.4));
    // Another one that is named leads.
    let simulated = shop.kerf("run there.sbp --machine shop --machine sim");
    simulated.exits(0);
    assert!(!simulated.err().contains("grbl 1.1h"), "{}", simulated.err());
}

#[test]
fn a_saved_machine_with_a_wrong_controller_is_never_simulated_instead() {
    let shop = Shop::new(&[("there.sbp", "MX,1\n")]);
    shop.kerf("machine save shop").exits(0);
    for (wrong, why) in [("grbl", "grbl needs its port"), ("shop", "is no controller")] {
        shop.kerf(&format!("set options.controller={wrong} --machine shop")).exits(0);
        shop.kerf("run there.sbp --machine shop")
            .exits(2)
            .complains("options.controller")
            .complains(why);
        // It can be mended all the same.
        let file = shop.file("data/machines/shop.toml");
        let text = std::fs::read_to_string(&file).unwrap();
        let mended = text.replace(&format!("controller = \"{wrong}\""), "controller = \"\"");
        assert_ne!(text, mended);
        std::fs::write(&file, mended).unwrap();
        shop.kerf("run there.sbp --machine shop").exits(0);
    }
}
