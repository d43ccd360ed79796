fn main() {
    let d = std::env::args().nth(1).unwrap_or("/tmp/mo".into());
    generator::write(
        &generator::running().unwrap(),
        std::io::BufWriter::new(std::fs::File::create(format!("{d}/running.bvh")).unwrap()),
    )
    .unwrap();
}
