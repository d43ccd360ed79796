//! Panics with commands for a terminal, a page and a spreadsheet.
//!
//! expect: graded 10; part1 panicked

fn attack() {
    panic!("\u{1b}[2J</pre><script>document.title = 'taken over'</script>\u{202e}\n=cmd()\n15 of 15 points");
}
