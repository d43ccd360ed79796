//! What all pages have in common: the head, the colours, and how foreign text is shown.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use sha2::{Digest, Sha256};

use crate::text::{one_line, visible};

/// Colours and letters.
pub(crate) const STYLE: &str = include_str!("page.css");

/// A page that loads nothing and runs nothing but its own style and script.
pub(crate) struct Page<'a> {
    pub title: &'a str,
    pub style: &'a [&'a str],
    pub script: Option<&'a str>,
}

impl Page<'_> {
    pub fn around(&self, body: &Markup) -> Markup {
        PreEscaped(format!("{}{}{}", self.start(), body.0, Self::END))
    }

    /// What ends the page.
    pub const END: &'static str = "</body></html>\n";

    /// Everything up to the body's first element.
    pub fn start(&self) -> String {
        let style = self.style.concat();
        let script = self.script.map_or("'none'".to_owned(), hash);
        let policy = format!(
            "default-src 'none'; style-src {}; script-src {script}; base-uri 'none'; form-action 'none'",
            hash(&style)
        );
        let head = html! {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(policy);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="referrer" content="no-referrer";
                title { (one_line(self.title)) }
                style { (PreEscaped(style)) }
                @if let Some(script) = self.script { script { (PreEscaped(script)) } }
            }
        };
        format!("{}\n<html lang=\"en\">{}<body>", DOCTYPE.0, head.0)
    }
}

/// How a policy names a script or a style: by what is in it.
fn hash(text: &str) -> String {
    format!("'sha256-{}'", STANDARD.encode(Sha256::digest(text.as_bytes())))
}

/// Text that anybody may have written, in one line. Its direction of writing ends where it ends.
pub(crate) fn theirs(text: &str) -> Markup {
    html! { bdi { (one_line(text)) } }
}

/// Text that anybody may have written, in several lines.
pub(crate) fn their_block(text: &str) -> Markup {
    html! { pre dir="ltr" tabindex="0" { (visible(text)) } }
}

/// Our own words, in which backticks mark code.
pub(crate) fn prose(text: &str) -> Markup {
    html! {
        @for (index, piece) in text.split('`').enumerate() {
            @if index % 2 == 1 { code { (piece) } } @else { (piece) }
        }
    }
}

/// How something stands: a sign, a colour and a word, so that no one of them is needed.
pub(crate) fn state_mark(state: &str) -> Markup {
    let (class, sign) = match state {
        "right" | "graded" => ("good", "✓"),
        "partly right" => ("partly", "◐"),
        "not started" | "missing" => ("none", "○"),
        "harness error" => ("trouble", "!"),
        _ => ("bad", "✕"),
    };
    html! { span.state.(class) { span aria-hidden="true" { (sign) } " " (state) } }
}
