//! A real browser, driven by the W3C's WebDriver protocol.
//!
//! The protocol is JSON over HTTP, so a plain HTTP client is enough. The existing WebDriver
//! clients need an asynchronous runtime.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use serde_json::{Value, json};
use tempfile::TempDir;

const REMEDY: &str = "a report is tested in a real browser; on Debian: \
                      apt-get install chromium chromium-driver (tools/test does it)";

/// Flags that keep out a person's browser settings and all background network traffic.
const FLAGS: [&str; 9] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--hide-scrollbars",
];

/// Keys as WebDriver spells them.
pub const TAB: &str = "\u{e004}";
pub const ENTER: &str = "\u{e007}";
pub const SPACE: &str = "\u{e00d}";
pub const SHIFT: &str = "\u{e008}";
pub const LEFT: &str = "\u{e012}";
pub const UP: &str = "\u{e013}";
pub const RIGHT: &str = "\u{e014}";
pub const DOWN: &str = "\u{e015}";

/// One headless Chromium with a fresh profile.
pub struct Browser {
    driver: Child,
    session: String,
    _profile: TempDir,
}

impl Browser {
    /// A browser that shows a file from disk.
    pub fn open(page: &Path) -> Browser {
        let profile = tempfile::tempdir().expect("a folder can be made");
        let mut driver = Command::new("chromedriver")
            .arg("--port=0")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap_or_else(|error| panic!("chromedriver: {error}\n  remedy: {REMEDY}"));
        let said = BufReader::new(driver.stdout.take().expect("it is piped")).lines();
        let port = said.map_while(Result::ok).find_map(|line| {
            let port = line.split_once("started successfully on port ")?.1;
            Some(port.trim_end_matches('.').to_owned())
        });
        let port =
            port.unwrap_or_else(|| panic!("chromedriver printed no port\n  remedy: {REMEDY}"));
        let server = format!("http://127.0.0.1:{port}/session");
        let mut flags: Vec<String> = FLAGS.map(String::from).into();
        flags.push(format!("--user-data-dir={}", profile.path().display()));
        let wanted = json!({ "capabilities": { "alwaysMatch": {
            "goog:chromeOptions": { "args": flags, "perfLoggingPrefs": { "enableNetwork": true } },
            "goog:loggingPrefs": { "browser": "ALL", "performance": "ALL" },
        } } });
        let made = send(&server, &wanted);
        let id = made["sessionId"].as_str();
        let id = id.unwrap_or_else(|| panic!("no browser: {made:#}\n  remedy: {REMEDY}"));
        let browser = Browser {
            driver,
            session: format!("{server}/{id}"),
            _profile: profile,
        };
        browser.screen(1280, 900);
        browser.load(page);
        browser
    }

    /// Shows another file, or reloads the same one.
    pub fn load(&self, page: &Path) {
        let page = page.canonicalize().expect("the page exists");
        let path = page.to_str().expect("test folders have plain names");
        // Escape the characters of a path that have a meaning in an address.
        let path = path
            .replace('%', "%25")
            .replace('#', "%23")
            .replace('?', "%3F");
        self.ask("url", json!({ "url": format!("file://{path}") }));
        self.wait_for("document.readyState === 'complete'");
    }

    fn ask(&self, what: &str, about: Value) -> Value {
        let answer = send(&format!("{}/{what}", self.session), &about);
        assert!(answer["error"].is_null(), "{what} {about}: {answer:#}");
        answer
    }

    /// The value of a JavaScript expression.
    #[track_caller]
    pub fn value(&self, expression: &str) -> Value {
        let script = format!("return ({expression});");
        self.ask("execute/sync", json!({ "script": script, "args": [] }))
    }

    /// The value of a JavaScript expression, which is text.
    #[track_caller]
    pub fn text(&self, expression: &str) -> String {
        let value = self.value(expression);
        let text = value.as_str().map(str::to_owned);
        text.unwrap_or_else(|| panic!("{expression} is {value}"))
    }

    /// Waits, twenty seconds at most, until an expression is true.
    #[track_caller]
    pub fn wait_for(&self, expression: &str) {
        for _ in 0..400 {
            if self.value(expression) == true {
                return;
            }
            std::thread::sleep(std::time::Duration::from_millis(50));
        }
        panic!("never true: {expression}");
    }

    /// Clicks with the mouse, at a point of the window.
    pub fn click(&self, x: f64, y: f64) {
        let actions = json!([
            { "type": "pointerMove", "duration": 0, "x": x.round(), "y": y.round() },
            { "type": "pointerDown", "button": 0 },
            { "type": "pointerUp", "button": 0 },
        ]);
        let mouse = json!({ "type": "pointer", "id": "mouse", "actions": actions });
        self.ask("actions", json!({ "actions": [mouse] }));
    }

    /// Clicks with the mouse on the middle of the first element that a selector finds.
    #[track_caller]
    pub fn click_on(&self, selector: &str) {
        let [x, y, ..] = self.rectangle(selector, 0.5, 0.5);
        self.click(x, y);
    }

    /// Scrolls an element into view. Returns a point of it, given by shares of its width and
    /// height, and then its width and height.
    #[track_caller]
    pub fn rectangle(&self, selector: &str, across: f64, down: f64) -> [f64; 4] {
        let found = self.value(&format!(
            "(() => {{ const e = document.querySelector({}); \
             e.scrollIntoView({{ block: 'center', behavior: 'instant' }}); \
             const r = e.getBoundingClientRect(); \
             return [r.left + {across} * r.width, r.top + {down} * r.height, r.width, r.height]; }})()",
            json!(selector)
        ));
        serde_json::from_value(found).unwrap_or_else(|error| panic!("{selector}: {error}"))
    }

    /// Presses keys one after another.
    pub fn press(&self, keys: &[&str]) {
        let strokes = keys
            .iter()
            .flat_map(|key| ["keyDown", "keyUp"].map(|kind| json!({ "type": kind, "value": key })));
        self.type_in(strokes.collect());
    }

    /// Presses one key while shift is held.
    pub fn press_with_shift(&self, key: &str) {
        let stroke = |kind: &str, key: &str| json!({ "type": kind, "value": key });
        self.type_in(vec![
            stroke("keyDown", SHIFT),
            stroke("keyDown", key),
            stroke("keyUp", key),
            stroke("keyUp", SHIFT),
        ]);
    }

    fn type_in(&self, strokes: Vec<Value>) {
        let keyboard = json!({ "type": "key", "id": "keyboard", "actions": strokes });
        self.ask("actions", json!({ "actions": [keyboard] }));
    }

    /// Tabs on until an element that matches has the focus.
    #[track_caller]
    pub fn tab_to(&self, selector: &str) {
        for _ in 0..200 {
            if self.value(&format!(
                "document.activeElement.matches({})",
                json!(selector)
            )) == true
            {
                return;
            }
            self.press(&[TAB]);
        }
        panic!("no tab leads to {selector}");
    }

    /// Sends a command that only Chromium has.
    pub fn command(&self, name: &str, parameters: Value) -> Value {
        self.ask(
            "goog/cdp/execute",
            json!({ "cmd": name, "params": parameters }),
        )
    }

    /// Gives the window this size.
    pub fn screen(&self, width: u32, height: u32) {
        let metrics = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600 });
        self.command("Emulation.setDeviceMetricsOverride", metrics);
    }

    /// Sets a preference, such as `prefers-color-scheme` to `dark`.
    pub fn prefer(&self, feature: &str, value: &str) {
        let features = json!([{ "name": feature, "value": value }]);
        self.command(
            "Emulation.setEmulatedMedia",
            json!({ "features": features }),
        );
    }

    /// The addresses of everything that was requested, except files, data in the page itself,
    /// and the browser's own pages.
    fn requests(&self) -> Vec<String> {
        let log = self.ask("se/log", json!({ "type": "performance" }));
        let entries = log.as_array().cloned().unwrap_or_default();
        let messages = entries
            .iter()
            .filter_map(|entry| serde_json::from_str::<Value>(entry["message"].as_str()?).ok());
        let sent =
            messages.filter(|message| message["message"]["method"] == "Network.requestWillBeSent");
        let addresses = sent.map(|message| {
            message["message"]["params"]["request"]["url"]
                .as_str()
                .unwrap_or_default()
                .to_owned()
        });
        let is_ours = |address: &String| {
            ["file:", "data:", "blob:", "chrome:", "chrome-untrusted:"]
                .iter()
                .any(|kind| address.starts_with(kind))
        };
        addresses.filter(|address| !is_ours(address)).collect()
    }

    /// Checks that the page made no requests and logged no errors.
    #[track_caller]
    pub fn expect_quiet(&self) {
        assert_eq!(self.requests(), Vec::<String>::new());
        let console = self.ask("se/log", json!({ "type": "browser" }));
        assert_eq!(console, json!([]), "the console says something");
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _already_gone = ureq::delete(&self.session).call();
        let _already_gone = self.driver.kill();
        let _already_gone = self.driver.wait();
    }
}

/// Sends one command. Returns the value of the answer, or an object with `error`.
fn send(address: &str, what: &Value) -> Value {
    let agent: ureq::Agent = ureq::Agent::config_builder()
        .http_status_as_error(false)
        .build()
        .into();
    let mut answer = agent
        .post(address)
        .content_type("application/json")
        .send(what.to_string())
        .unwrap_or_else(|error| panic!("chromedriver does not answer: {error}"));
    let body = answer
        .body_mut()
        .read_to_string()
        .expect("it answers in text");
    let answer: Value = serde_json::from_str(&body).expect("it answers in JSON");
    answer["value"].clone()
}
