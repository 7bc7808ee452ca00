//! `kerf machine zeros`: the zero points of a controller, from the shell.

use crate::bench::Bench;
use crate::close;
use crate::shop::{Did, Shop};

fn zeros(bench: &Bench, shop: &Shop, words: &str) -> Did {
    shop.kerf(&format!("machine zeros {words} --machine grbl:{}", bench.port))
}

/// The line of a zero point, its words.
fn line(did: &Did, name: &str) -> Vec<String> {
    let out = did.out();
    let found = out.lines().find(|line| line.split(' ').next() == Some(name)).unwrap();
    found.split_whitespace().map(str::to_owned).collect()
}

#[test]
fn zero_points_are_listed_set_chosen_and_cleared_and_a_program_follows() {
    let (shop, bench) = (Shop::new(&[("to_zero.nc", "G21\nG0 X0 Y0\n")]), Bench::new(&[]));
    let listed = zeros(&bench, &shop, "");
    assert_eq!(line(listed.exits(0), "G54"), ["G54", "0", "0", "0", "holds"]);
    zeros(&bench, &shop, "set G54 -20,5,").exits(0);
    let listed = zeros(&bench, &shop, "");
    assert_eq!(line(listed.exits(0), "G54"), ["G54", "20", "-5", "0", "holds"]);
    let goes = |x: f64, y: f64| {
        bench.run(&shop, "run to_zero.nc").exits(0);
        let [at_x, at_y, ..] = bench.look(|fake| fake.position()).0;
        assert!(close(at_x, x) && close(at_y, y), "{at_x} {at_y} is not {x} {y}");
    };
    goes(20.0, -5.0);
    zeros(&bench, &shop, "set g55 7,8,0 --from-home").exits(0);
    goes(20.0, -5.0);
    zeros(&bench, &shop, "use G55").exits(0);
    goes(7.0, 8.0);
    bench.look(|fake| fake.offsets.shift.0[0] = 3.0);
    zeros(&bench, &shop, "clear").exits(0);
    assert!(bench.look(|fake| close(fake.offsets.shift.0[0], 0.0)));
}

#[test]
fn what_is_no_zero_point_is_refused() {
    let (shop, bench) = (Shop::new(&[]), Bench::new(&[]));
    zeros(&bench, &shop, "use G60").exits(1).complains("does not change its zero point G60");
    zeros(&bench, &shop, "set G54 ,,").exits(2).complains("one axis at least");
    shop.kerf("machine zeros").exits(2).complains("name the controller");
}
