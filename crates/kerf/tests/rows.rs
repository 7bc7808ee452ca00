//! Rows that need a disk, several files or exit codes.

#![allow(clippy::unwrap_used, clippy::expect_used, non_snake_case)]

mod shop;

use shop::Shop;

#[test]
fn sbp_io_open_absolute() {
    let shop = Shop::new(&[("parts/x.txt", ""), ("other/y.txt", ""), ("other/myfolder/z.txt", "")]);
    let open = |path: &str| {
        let program = format!("OPEN \"{path}\" FOR OUTPUT AS #1\nWRITE #1; \"A\"\nCLOSE #1\n");
        shop.write("parts/a.sbp", program.as_bytes());
    };
    let posix = shop.file("other/out.txt").display().to_string();
    open(&posix);
    shop.kerf("run parts/a.sbp").exits(1).complains("outside the folders that may be used");
    shop.kerf("run parts/a.sbp --allow-path other").exits(0);
    assert_eq!(shop.read("other/out.txt"), "A\n");
    open("C:\\myfolder\\myfile.sbp");
    shop.kerf("run parts/a.sbp").exits(1).complains("--allow-path");
    shop.kerf("run parts/a.sbp --allow-path other").exits(0);
    assert_eq!(shop.read("other/myfolder/myfile.sbp"), "A\n");
}

#[test]
fn sbp_io_input_headless() {
    let program = "INPUT \"Depth?\" &d\nMSGBOX(Go?,YesNo,x)\nPAUSE\nMZ,&d\n";
    let shop = Shop::new(&[
        ("a.sbp", program),
        ("all.txt", "-.25\nYes\nOK\n"),
        ("lines.txt", "3:OK\n2:No\n1:-.5\n"),
        ("cancel.txt", "-.25\nYes\nCancel\n"),
    ]);
    let depth = |answers: &str| {
        let did = shop.kerf(&format!("trace a.sbp --answers {answers}"));
        did.exits(0);
        let answers: Vec<_> = did.all("ask").iter().map(|a| a["answer"].to_string()).collect();
        (answers.join(" "), did.all("move")[0]["to"]["z"].as_f64().unwrap())
    };
    assert_eq!(depth("all.txt"), ("\"-.25\" \"Yes\" \"OK\"".into(), -0.25));
    assert_eq!(depth("lines.txt"), ("\"-.5\" \"No\" \"OK\"".into(), -0.5));
    shop.kerf("run a.sbp --answers cancel.txt").exits(3);
}

#[test]
fn sbp_file_check() {
    let shop = Shop::new(&[
        ("good.sbp", "FP,part.sbp\nGOTO OUT\nMX,9\nOUT:\n"),
        ("part.sbp", "JZ,.5\nM3,4,3,-.25\n"),
        ("limit.sbp", "VL,0,10\nSF,1\nMX,12\n"),
        ("label.sbp", "GOTO NOWHERE\n"),
        ("nested.sbp", "FP,bad.sbp\n"),
        ("bad.sbp", "M23,1\n"),
    ]);
    let good = shop.kerf("check good.sbp");
    good.exits(0).says("good.sbp: ").says(" s, cutting X 0 … 4, Y 0 … 3, Z -0.25 … 0.5 in");
    for (file, code) in [("limit", "M001"), ("label", "R005"), ("nested", "S002")] {
        shop.kerf(&format!("check {file}.sbp")).exits(1).says(code);
    }
    assert_eq!(shop.names().len(), 6, "nothing is written");
}
