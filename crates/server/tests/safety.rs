//! Rights: to be let in, and to move the machine.

use crate::support;
use crate::support::{Page, Shop, Wanted, builders, shop, start};
use kerf_server::{Options, Server};
use serde_json::{Value, json};

/// The cookie of a paired device: cookies know no ports, and each machine of a host has devices of its own.
fn device_cookie(shop: &Shop) -> String {
    format!("kerf-device-{}", shop.server.address.port())
}

/// Every path of the router with every method, and what lies beside its paths.
fn requests() -> Vec<String> {
    let beside = ["/", "/edit", "/assets/x.js", "/api/nothing"];
    let named = |path: &str| {
        let part = |part: &str| if part.starts_with('{') { "x".into() } else { part.to_owned() };
        path.split('/').map(part).collect::<Vec<_>>().join("/")
    };
    let paths = kerf_server::paths().into_iter().map(named).chain(beside.map(str::to_owned));
    let methods = ["GET", "POST", "PUT", "DELETE"];
    paths.flat_map(|path| methods.map(|method| format!("{method} {path}"))).collect()
}

#[test]
fn a_foreign_host_is_refused_on_every_route() {
    let shop = shop(1.0, &[("a.sbp", "MX,1")]);
    let port = shop.server.address.port();
    for route in &requests() {
        for host in [
            "evil.example".to_owned(),
            format!("evil.example:{port}"),
            format!("127.0.0.1.evil.example:{port}"),
            format!("127.0.0.2:{port}"),
            "127.0.0.1:1".into(),
            "127.0.0.1".into(),
            String::new(),
        ] {
            let json = ("Content-Type", "application/json");
            let answer = shop.ask(route, &[("Host", &host), json], b"{}");
            assert!([421, 400].contains(&answer.status), "{route} {host}: {}", answer.status);
        }
    }
    assert_eq!(std::fs::read(shop.part("a.sbp")).unwrap(), b"MX,1");
}

#[test]
fn a_foreign_origin_is_refused_on_every_route() {
    let shop = shop(1.0, &[("a.sbp", "MX,1")]);
    let address = shop.server.address;
    for route in &requests() {
        for origin in
            ["http://evil.example", "null", &format!("https://{address}"), "http://localhost"]
        {
            let json = ("Content-Type", "application/json");
            let answer = shop.ask(route, &[("Origin", origin), json], b"{}");
            assert_eq!(answer.status, 403, "{route} {origin}");
        }
    }
    assert_eq!(Page::open(address, &[("origin", "http://evil.example")]).err(), Some(403));
    assert_eq!(Page::open(address, &[("origin", "")]).err(), Some(403), "no origin at all");
    assert!(Page::open(address, &[]).is_ok());
    assert_eq!(std::fs::read(shop.part("a.sbp")).unwrap(), b"MX,1");
}

#[test]
fn no_header_of_a_proxy_is_believed() {
    let shop = start(Wanted { lan: true, ..Wanted::default() });
    let ours = shop.server.address.to_string();
    let evil = "evil.example";
    for name in ["Forwarded", "X-Forwarded-For", "X-Forwarded-Host", "X-Real-IP"] {
        let foreign = shop.ask("GET /api/state", &[("Host", evil), (name, &ours)], b"");
        assert_eq!(foreign.status, 421, "{name} does not stand for the host");
        let origin = ("Origin", "http://evil.example");
        let foreign = shop.ask("GET /api/state", &[origin, (name, evil)], b"");
        assert_eq!(foreign.status, 403, "{name} does not stand for the origin");
        // Whoever comes through a proxy is not at the machine itself.
        assert_eq!(shop.ask("GET /api/state", &[(name, "127.0.0.1")], b"").status, 401, "{name}");
    }
}

#[test]
fn this_machine_by_its_own_names_is_let_in() {
    let shop = shop(1.0, &[]);
    let port = shop.server.address.port();
    for host in
        [format!("localhost:{port}"), format!("LOCALHOST:{port}"), format!("127.0.0.1:{port}")]
    {
        assert_eq!(shop.ask("GET /api/state", &[("Host", &host)], b"").status, 200, "{host}");
    }
}

#[test]
fn looking_changes_nothing_and_what_changes_takes_json() {
    let shop = shop(1.0, &[]);
    for act in ["stop", "hold", "arm", "disarm", "run"] {
        assert_eq!(shop.get(&format!("/api/do/{act}")).status, 405, "{act}");
    }
    // A form of a foreign page is no JSON.
    let form = ("Content-Type", "application/x-www-form-urlencoded");
    assert_eq!(shop.ask("POST /api/do/arm", &[form], b"a=b").status, 415);
    assert_eq!(shop.ask("POST /api/do/arm", &[("Content-Type", "text/plain")], b"{}").status, 415);
    assert_eq!(shop.ask("OPTIONS /api/do/stop", &[], b"").status, 405);
    assert_eq!(shop.post("/api/do/stop", json!({}), &[]).status, 200);
}

#[test]
fn every_answer_is_strict_and_none_invites_other_sites() {
    let shop = shop(1.0, &[]);
    for path in ["/", "/api/state", "/nothing.js", "/api/nothing/at/all"] {
        let head = shop.get(path).head;
        assert!(head.contains("content-security-policy: default-src 'none'"), "{path} {head}");
        assert!(head.contains("frame-ancestors 'none'"), "{path}");
        assert!(head.contains("x-content-type-options: nosniff"), "{path}");
        assert!(!head.contains("access-control-"), "{path}");
        assert!(!head.contains("unsafe-"), "{path}");
    }
    let nonce = |text: &str| text.split("nonce-").nth(1).unwrap()[..32].to_owned();
    let (first, second) = (shop.get("/"), shop.get("/"));
    assert_ne!(nonce(&first.head), nonce(&second.head));
    assert!(String::from_utf8_lossy(&first.body).contains(&nonce(&first.head)));
}

#[test]
fn nothing_is_written_or_read_outside_the_part_folder() {
    let shop = shop(1.0, &[]);
    std::fs::write(shop.dir.path().join("secret.txt"), "x").unwrap();
    for name in [
        "../secret.txt",
        "..%2fsecret.txt",
        "%2e%2e/secret.txt",
        "%2e%2e%2fsecret.txt",
        "..%5csecret.txt",
        "doors/../../secret.txt",
        "%2fetc%2fpasswd",
        "/etc/passwd",
        "a%00b",
        ".hidden",
        "nowhere/new.sbp",
    ] {
        let put = shop.ask(&format!("PUT /api/files/{name}"), &[], b"y");
        let get = shop.get(&format!("/api/files/{name}"));
        assert!(put.status >= 400 && get.status >= 400, "{name}: {} {}", put.status, get.status);
    }
    assert_eq!(std::fs::read(shop.dir.path().join("secret.txt")).unwrap(), b"x");
    assert_eq!(shop.ask("PUT /api/files/new.sbp", &[], b"MX,1").status, 200);
    assert_eq!(std::fs::read(shop.part("new.sbp")).unwrap(), b"MX,1");
    assert_eq!(shop.get("/api/files/new.sbp").body, b"MX,1");
    assert_eq!(shop.get("/api/files").json()[0]["name"], "new.sbp");
}

#[test]
fn other_machines_need_leave() {
    let dir = tempfile::tempdir().unwrap();
    let options = Options {
        listen: ([0, 0, 0, 0], 0).into(),
        lan: false,
        names: Vec::new(),
        parts: dir.path().into(),
        data: dir.path().join("data"),
        drawing_only: false,
        open: None,
        closes_with_program: false,
        webhook: None,
        rate: 1.0,
        start: None,
        begin_with: Vec::new(),
    };
    let started = Server::start(options, builders(dir.path(), |_| {}));
    assert_eq!(started.err().unwrap().kind(), std::io::ErrorKind::PermissionDenied);
}

/// Through a proxy: not at the machine, whatever it says of itself.
const ELSEWHERE: (&str, &str) = ("X-Forwarded-For", "127.0.0.1");

#[test]
fn a_device_is_paired_by_the_code_and_has_its_role_until_it_is_revoked() {
    let shop = start(Wanted { lan: true, ..Wanted::default() });
    let state = |headers: &[(&str, &str)]| shop.ask("GET /api/state", headers, b"").status;
    assert_eq!(state(&[ELSEWHERE]), 401);
    assert_eq!(shop.ask("GET /", &[ELSEWHERE], b"").status, 200, "the page that asks for the code");
    let code = shop.post("/api/pair/code", json!({ "role": "observer" }), &[]).json();
    let code = code["code"].as_str().unwrap();
    let wrong = shop.post("/api/pair", json!({ "code": "x", "name": "tablet" }), &[ELSEWHERE]);
    assert_eq!(wrong.status, 403);
    // The next code counts a moment later.
    std::thread::sleep(std::time::Duration::from_millis(1100));
    let paired = shop.post("/api/pair", json!({ "code": code, "name": "tablet" }), &[ELSEWHERE]);
    assert!(paired.head.contains("httponly") && paired.head.contains("samesite=strict"));
    let token = paired.json()["token"].as_str().unwrap().to_owned();
    let cookie = format!("{}={token}", device_cookie(&shop));
    let bearer = format!("Bearer {token}");
    assert_eq!(state(&[ELSEWHERE, ("Cookie", &cookie)]), 200);
    assert_eq!(state(&[ELSEWHERE, ("Authorization", &bearer)]), 200);
    assert_eq!(state(&[ELSEWHERE, ("Cookie", &format!("{}=guess", device_cookie(&shop)))]), 401);

    let as_device = [ELSEWHERE, ("Cookie", cookie.as_str())];
    let act = |name: &str, body| shop.post(&format!("/api/do/{name}"), body, &as_device).status;
    assert_eq!((act("stop", json!({})), act("hold", json!({}))), (200, 200));
    assert_eq!(act("takeLease", json!({ "force": true })), 403);
    assert_eq!(act("open", json!({ "name": "a.sbp" })), 403);
    assert_eq!(shop.ask("PUT /api/files/a.sbp", &as_device, b"MX,1").status, 403);
    assert_eq!(shop.ask("GET /api/devices", &as_device, b"").status, 403);

    let mut page = Page::open(shop.server.address, &as_device).unwrap();
    assert_eq!(page.who["role"], "observer");
    let number = shop.get("/api/devices").json()[0]["number"].clone();
    assert_eq!(shop.ask(&format!("DELETE /api/devices/{number}"), &[], b"").status, 200);
    assert_eq!(state(&as_device), 401);
    let begin = std::time::Instant::now();
    while page.read() {
        assert!(begin.elapsed().as_secs() < 10, "the socket of a revoked device stays open");
    }
}

#[test]
fn the_history_of_settings_tells_which_device_changed_one() {
    let shop = start(Wanted { lan: true, ..Wanted::default() });
    let code = shop.post("/api/pair/code", json!({ "role": "setter" }), &[]).json();
    let named = json!({ "code": code["code"], "name": "tablet" });
    let token = shop.post("/api/pair", named, &[ELSEWHERE]).json()["token"].clone();
    let cookie = format!("{}={}", device_cookie(&shop), token.as_str().unwrap());
    let act = |name: &str, body| {
        shop.post(&format!("/api/do/{name}"), body, &[ELSEWHERE, ("Cookie", &cookie)])
    };
    assert_eq!(act("takeLease", json!({ "force": true })).status, 200);
    let lease = shop.get("/api/state").json()["lease"]["number"].clone();
    let changed = json!({ "lease": lease, "key": "cutter.diameter_mm", "value": "9.5" });
    let changed = act("set", changed);
    assert_eq!(changed.status, 200, "{}", changed.json());
    let changes = shop.get("/api/settings?changes").json();
    assert_eq!((&changes[0]["by"], &changes[0]["to"]), (&json!("tablet"), &json!("9.5")));
}

#[test]
fn who_sits_at_the_machine_shows_it_where_others_may_connect() {
    let shop = start(Wanted { lan: true, ..Wanted::default() });
    let state = |headers: &[(&str, &str)]| shop.ask("GET /api/state", headers, b"").status;
    let way_in = shop.server.way_in();
    let (address, token) = way_in.split_once("/?token=").unwrap();
    assert_eq!(address, format!("http://{}", shop.server.address));
    // A relay on this computer that adds no header is nobody.
    let nobody = ("Authorization", "Bearer guess");
    assert_eq!(state(&[nobody]), 401);
    assert_eq!(Page::open(shop.server.address, &[nobody]).err(), Some(401));
    assert_eq!(shop.post("/api/do/takeLease", json!({ "force": true }), &[nobody]).status, 401);
    let bearer = format!("Bearer {token}");
    assert_eq!(state(&[("Authorization", &bearer)]), 200);
    assert_eq!(state(&[("Authorization", &bearer), ELSEWHERE]), 401, "from elsewhere it is none");

    let enters = |token: &str| shop.ask(&format!("GET /?token={token}"), &[nobody], b"");
    let wrong = enters("guess");
    assert_eq!((wrong.status, wrong.head.contains("set-cookie")), (303, false));
    let entered = enters(token);
    assert_eq!(entered.status, 303);
    assert!(entered.head.contains("location: /\r\n"), "{}", entered.head);
    let cookie = entered.head.split("set-cookie: ").nth(1).unwrap().split("; ").next().unwrap();
    assert!(entered.head.contains("httponly") && entered.head.contains("samesite=strict"));
    assert!(cookie.starts_with(&format!("kerf-here-{}=", shop.server.address.port())));
    assert_eq!(state(&[("Cookie", cookie)]), 200);
    let page = Page::open(shop.server.address, &[("Cookie", cookie)]).unwrap();
    assert_eq!(page.who["role"], "owner");
    let moved = shop.ask(&format!("GET /?token={token}"), &[nobody, ELSEWHERE], b"");
    assert!(!moved.head.contains("set-cookie"), "not through a proxy");

    let kept = std::fs::read_to_string(shop.dir.path().join("data").join(kerf_server::TOKEN_FILE));
    assert_eq!(kept.unwrap(), token);
}

#[test]
fn nobody_but_this_computer_needs_no_token() {
    let shop = shop(1.0, &[]);
    assert_eq!(shop.server.way_in(), format!("http://{}", shop.server.address));
    assert_eq!(shop.get("/api/state").status, 200);
    assert!(!shop.dir.path().join("data").join(kerf_server::TOKEN_FILE).exists());
}

#[test]
fn strangers_neither_use_a_code_up_nor_stay_unseen() {
    let shop = start(Wanted { lan: true, ..Wanted::default() });
    let mut page = shop.page();
    let code = shop.post("/api/pair/code", json!({ "role": "observer" }), &[]).json();
    let code = code["code"].as_str().unwrap();
    let pair = |code: &str| {
        shop.post("/api/pair", json!({ "code": code, "name": "tablet" }), &[ELSEWHERE])
    };
    assert_eq!(pair("x").status, 403);
    let told =
        |page: &Page| page.shown["messages"].to_string().contains("tried a wrong code, 1 wrong");
    page.until("the page is told", told);
    // A computer that is busy may take the second for this one answer.
    let early = pair("y");
    assert_eq!(early.status, 403);
    let text = early.json()["text"].to_string();
    assert!(text.contains("wait 1 s") || text.contains("not the code"), "{text}");
    std::thread::sleep(std::time::Duration::from_millis(2100));
    assert_eq!(pair(code).status, 200, "the code is good as before");
}

#[test]
fn a_list_of_devices_that_is_none_is_put_aside_and_told() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::create_dir_all(dir.path().join("data")).unwrap();
    std::fs::write(dir.path().join("data/devices.json"), "").unwrap();
    let shop = support::kept(dir);
    let page = shop.page();
    let told = page.shown["messages"].to_string();
    assert!(
        told.contains("devices.json.broken-1") && told.contains("No device is paired"),
        "{told}"
    );
    assert!(shop.dir.path().join("data/devices.json.broken-1").exists());
}

#[test]
fn a_page_that_is_not_heard_any_more_is_told_nothing() {
    let shop = shop(1.0, &[]);
    let (mut page, mut other) = (shop.page(), shop.page());
    page.garble();
    other.until("it has gone", |other| other.shown["clients"].as_array().unwrap().len() == 1);
    let begin = std::time::Instant::now();
    while page.read() {
        assert!(
            begin.elapsed().as_secs() < 5,
            "its STOP would not be heard, and it would not know"
        );
    }
}

#[test]
fn one_drives_at_a_time_and_every_command_names_the_turn() {
    let shop = shop(50.0, &[("a.sbp", "MX,1")]);
    let (mut a, mut b) = (shop.page(), shop.page());
    a.open_file("a.sbp");
    assert_eq!(a.run().as_deref(), Some("lease"), "nobody drives");
    a.drive();
    b.until("the file", |page| !page.shown["opened"].is_null());
    b.lease = a.lease;
    assert_eq!(b.run().as_deref(), Some("lease"), "somebody else's number");
    assert_eq!(b.act(json!({ "do": "takeLease", "force": false })).as_deref(), Some("lease"));
    let old = a.lease;
    b.drive();
    assert_ne!(b.lease, old);
    assert_eq!(a.run().as_deref(), Some("lease"));
    assert_eq!(b.run(), None);
}

#[test]
fn whatever_moves_or_changes_the_machine_names_the_turn() {
    let shop = shop(50.0, &[("a.sbp", "MX,1")]);
    let (mut page, mut driver) = (shop.page(), shop.driver());
    driver.open_file("a.sbp");
    let hash = driver.shown["opened"]["hash"].clone();
    let acts = [
        json!({ "do": "run", "hash": hash }),
        json!({ "do": "takeUp" }),
        json!({ "do": "command", "line": "MX,1" }),
        json!({ "do": "resume" }),
        json!({ "do": "nudge", "axis": "X", "distance": 1.0 }),
        json!({ "do": "jogStart", "seq": 1, "clockMs": 0.0, "direction": [1, 0, 0, 0, 0, 0], "distance": null, "speedShare": 1.0 }),
        json!({ "do": "jogRenew", "seq": 1, "clockMs": 0.0 }),
        json!({ "do": "arm" }),
        json!({ "do": "override", "feedPercent": 50.0 }),
        json!({ "do": "input", "number": 1, "on": true }),
        json!({ "do": "set", "key": "options.filter_mm", "value": "1" }),
    ];
    for act in acts {
        let name = act["do"].as_str().unwrap().to_owned();
        let mut body = act.clone();
        body.as_object_mut().unwrap().remove("do");
        let without = shop.post(&format!("/api/do/{name}"), body, &[]).status;
        assert_eq!(without, 400, "without a turn: {act}");
        for turn in [0, driver.lease - 1, driver.lease, driver.lease + 1] {
            let mut act = act.clone();
            act["lease"] = turn.into();
            assert_eq!(page.act(act.clone()).as_deref(), Some("lease"), "turn {turn}: {act}");
        }
    }
    assert_eq!(driver.shown["machine"]["state"], "idle");
    assert_eq!(driver.x(), 0.0);
}

#[test]
fn the_machine_is_disarmed_at_first_and_whenever_the_driver_changes_or_goes() {
    let shop = shop(50.0, &[("a.sbp", "MX,1")]);
    let (mut a, mut watcher) = (shop.page(), shop.page());
    assert_eq!(a.shown["machine"]["armed"], false);
    a.open_file("a.sbp");
    a.act(json!({ "do": "takeLease", "force": false }));
    a.until("the lease", |page| !page.shown["lease"].is_null());
    a.lease = a.shown["lease"]["number"].as_u64().unwrap();
    assert_eq!(a.run().as_deref(), Some("disarmed"));
    a.act(json!({ "do": "arm", "lease": a.lease }));
    watcher.until("armed", |page| page.shown["machine"]["armed"] == true);
    watcher.act(json!({ "do": "takeLease", "force": true }));
    watcher.until("disarmed", |page| page.shown["machine"]["armed"] == false);
    watcher.drive();
    drop(watcher);
    a.until("the driver has gone", |page| page.shown["lease"].is_null());
    a.until("disarmed", |page| page.shown["machine"]["armed"] == false);
}

#[test]
fn files_that_a_job_calls_are_those_that_were_previewed() {
    let main = "FP,other.sbp,,,1\nOPEN \"made.sbp\" FOR OUTPUT AS #1\nWRITE #1; \"MX,2\"\nCLOSE #1\n\
                FP,made.sbp,,,1\n";
    let shop = shop(50.0, &[("main.sbp", main), ("other.sbp", "MX,1")]);
    let mut page = shop.driver();
    page.open_file("main.sbp");
    let before = page.shown["opened"]["hash"].clone();
    std::fs::write(shop.part("other.sbp"), "MX,100").unwrap();
    assert_eq!(page.run().as_deref(), Some("changed"));
    page.open_file("main.sbp");
    assert_ne!(page.shown["opened"]["hash"], before, "another job has another name");
    let old = json!({ "do": "run", "lease": page.lease, "hash": before });
    assert_eq!(page.act(old).as_deref(), Some("changed"));
    // What a program writes itself, and then runs, is its own.
    std::fs::write(shop.part("made.sbp"), "MX,3").unwrap();
    assert_eq!(page.run(), None);
    page.until("its end", |page| page.shown["job"]["ended"] == "ok");
    assert!((page.x() - 50.8).abs() < 1e-6, "{}", page.x());
}

#[test]
fn what_was_previewed_is_what_runs() {
    let shop = shop(50.0, &[("a.sbp", "MX,1"), ("wrong.sbp", "QQ,1")]);
    let mut page = shop.driver();
    page.open_file("a.sbp");
    let other = json!({ "do": "run", "lease": page.lease, "hash": "0".repeat(64) });
    assert_eq!(page.act(other).as_deref(), Some("changed"));
    std::fs::write(shop.part("a.sbp"), "MX,100").unwrap();
    assert_eq!(page.run().as_deref(), Some("changed"));
    page.open_file("wrong.sbp");
    assert_eq!(page.run().as_deref(), Some("mistake"));
    assert_eq!(page.x(), 0.0);
}

fn protect(page: &mut Page, password: Option<&str>, new: Value) -> Option<String> {
    page.act(json!({ "do": "protect", "password": password, "new": new }))
}

/// A script that drives tries to change a setting: the status.
fn filter(shop: &Shop) -> u16 {
    assert_eq!(shop.post("/api/do/takeLease", json!({ "force": true }), &[]).status, 200);
    let lease = shop.get("/api/state").json()["lease"]["number"].clone();
    let body = json!({ "lease": lease, "key": "options.filter_mm", "value": "0.02" });
    shop.post("/api/do/set", body, &[]).status
}

/// A page that drives tries to change a setting.
fn set(page: &mut Page) -> Option<String> {
    let act = json!({ "do": "set", "lease": page.lease, "key": "options.filter_mm", "value": "1" });
    let told = page.act(act);
    page.until_state("idle");
    told
}

#[test]
fn settings_are_protected_by_a_password() {
    let shop = support::kept(tempfile::tempdir().unwrap());
    std::fs::write(shop.part("a.sbp"), "MX,1\n").unwrap();
    let mut page = shop.driver();
    assert_eq!(protect(&mut page, None, json!(["birch", "birch"])), None);
    page.until("protection", |page| page.shown["setup"]["protected"] == true);
    page.until_state("idle");
    let kept = std::fs::read_to_string(shop.dir.path().join("data/machine.toml")).unwrap();
    assert!(kept.contains("pbkdf2-sha256$") && !kept.contains("birch"), "{kept}");
    let form = shop.get("/api/settings").json().to_string();
    assert!(form.contains("options.filter_mm") && !form.contains("pbkdf2"), "pages never see it");

    assert_eq!(set(&mut page).as_deref(), Some("password"));
    let values = json!({ "do": "command", "lease": page.lease, "line": "VS,2" });
    assert_eq!(page.act(values.clone()).as_deref(), Some("password"));
    let unlock =
        |page: &mut Page, word: &str| page.act(json!({ "do": "unlock", "password": word }));
    assert_eq!(unlock(&mut page, "beech").as_deref(), Some("password"));
    let early = page.send(json!({ "do": "unlock", "password": "birch" }));
    assert_eq!(
        page.problem(early),
        "wrong passwords were tried from here: wait 1 s, then try again"
    );
    let told = "a wrong password of the settings was tried: at the machine, 1 wrong so far";
    assert!(page.shown["messages"].to_string().contains(told), "everybody is told");
    std::thread::sleep(std::time::Duration::from_millis(1100));
    page.open_file("a.sbp");
    assert_eq!(page.run(), None, "running stays possible");
    page.until("the end", |page| page.shown["job"]["ended"] == "ok");
    page.until_state("idle");

    assert_eq!(unlock(&mut page, "birch"), None);
    assert_eq!(set(&mut page), None);
    assert_eq!(page.act(values), None);
    page.until_state("idle");
    assert_eq!(filter(&shop), 401, "another page is not let in by that");
    assert_eq!(shop.post("/api/do/unlock", json!({ "password": "birch" }), &[]).status, 200);
    assert_eq!(filter(&shop), 200);
}

#[test]
fn pro_options_password__part_files_and_lines_over_http() {
    let shop = support::kept(tempfile::tempdir().unwrap());
    std::fs::write(shop.part("sets.sbp"), "VC,.375\nSV\nMX,1\n").unwrap();
    let mut page = shop.driver();
    assert_eq!(protect(&mut page, None, json!(["birch", "birch"])), None);
    page.until("protection", |page| page.shown["setup"]["protected"] == true);
    page.until_state("idle");
    let file = shop.dir.path().join("data/machine.toml");
    let text = || std::fs::read_to_string(&file).unwrap();
    let kept = text();
    for line in ["UR,mine,0", "MS,3", "&a = 1\nIF &a = 1 THEN VC,.5"] {
        let typed = json!({ "do": "command", "lease": page.lease, "line": line });
        assert_eq!(page.act(typed).as_deref(), Some("password"), "{line}");
    }
    let ran = |page: &mut Page| {
        page.open_file("sets.sbp");
        assert_eq!(page.run(), None);
        page.until("its end", |page| page.shown["job"]["ended"] == "ok");
        page.until_state("idle");
    };
    ran(&mut page);
    assert_eq!(text(), kept, "a part file sets nothing for good");
    let refused = shop.ask("PUT /api/registry/uCommand", &[], b"VC,.5");
    assert_eq!((refused.status, refused.json()["why"].clone()), (401, json!("password")));
    // A program on this computer may pass it in; it sets nothing either.
    let (before, data) = (page.shown["job"]["run"].as_u64(), shop.dir.path().join("data"));
    std::fs::write(data.join("new"), "uCommand=VC,.5\n").unwrap();
    std::fs::rename(data.join("new"), data.join("registry.in")).unwrap();
    page.until("the passed line", |page| page.shown["job"]["run"].as_u64() > before);
    page.until("its failure", |page| page.shown["job"]["ended"] == "failed");
    page.until_state("idle");
    assert_eq!(text(), kept, "nor does what is passed in");
    assert_eq!(page.act(json!({ "do": "unlock", "password": "birch" })), None);
    ran(&mut page);
    assert!(text().contains("diameter_mm = 9.525"), "{}", text());
}

#[test]
fn pro_options_password_off() {
    let shop = shop(50.0, &[]);
    let mut page = shop.driver();
    assert_eq!(page.shown["setup"]["protected"], false);
    assert_eq!(set(&mut page), None);
    for wrong in [json!(["birch", "beech"]), json!(["a", "a"])] {
        assert_eq!(protect(&mut page, None, wrong).as_deref(), Some("mistake"));
    }
    assert_eq!(protect(&mut page, None, json!(["birch", "birch"])), None);
    page.until("protection", |page| page.shown["setup"]["protected"] == true);
    page.until_state("idle");
    assert_eq!(protect(&mut page, None, Value::Null).as_deref(), Some("password"));
    assert_eq!(protect(&mut page, Some("birch"), Value::Null), None);
    page.until("no protection", |page| page.shown["setup"]["protected"] == false);
    page.until_state("idle");
    assert_eq!(set(&mut page), None);
}

#[test]
fn where_only_drawings_are_worked_on_nothing_of_the_machine_is_to_be_had() {
    let shop = start(Wanted { drawing_only: true, ..Wanted::default() });
    let mut page = shop.page();
    assert_eq!(page.act(json!({ "do": "takeLease", "force": false })).as_deref(), Some("state"));
    for act in ["arm", "run", "command", "nudge", "override", "resume", "takeUp"] {
        let body = json!({ "lease": 1, "hash": "", "line": "MX,1", "axis": "X", "distance": 1.0, "feedPercent": 100.0 });
        let known = ["lease"].into_iter().chain(match act {
            "run" => vec!["hash"],
            "command" => vec!["line"],
            "nudge" => vec!["axis", "distance"],
            "override" => vec!["feedPercent"],
            _ => Vec::new(),
        });
        let body: Value = known.map(|key| (key.to_owned(), body[key].clone())).collect();
        let answer = shop.post(&format!("/api/do/{act}"), body, &[]);
        let told = answer.json()["text"].as_str().unwrap_or_default().to_owned();
        assert!(told.starts_with("this is not available in the editing version"), "{act}: {told}");
    }
    assert_eq!(
        page.act(json!({ "do": "draw", "op": { "op": "do", "clauses": "rect 0,0 9,9" } })),
        None
    );
    assert_eq!(page.act(json!({ "do": "draw", "op": { "op": "program", "name": "a.sbp" } })), None);
}
