use carvallo_design::input::{self, Request};
use carvallo_design::{Design, MODELS};

use super::{Limits, Scene, draw_eigenvalues, draw_side_view, draw_tornado, font};
use crate::analysis::Analysis;
use crate::analysis::sensitivity::Changes;

/// What ships for a model, or the first of it.
fn design(model: &str, parameters: Option<&str>) -> Design {
    let request =
        Request { model: Some(model.to_owned()), parameters: parameters.map(str::to_owned), ..Request::default() };
    input::load(&request).unwrap()
}

fn eigenvalues(design: Design) -> Scene {
    let analysis = Analysis::new(design).unwrap();
    draw_eigenvalues(&analysis, Limits { x: (0.0, analysis.reach), y: None }).unwrap()
}

fn texts(scene: &Scene) -> impl Iterator<Item = &str> {
    scene.items.iter().filter_map(|item| item.text.as_deref())
}

/// Every model draws what it can, and of nothing that it writes there is no glyph.
#[test]
fn the_font_has_the_characters_of_every_picture() {
    let mut count = 0;
    for model in MODELS {
        let load = || design(model.info.name, None);
        let mut scenes: Vec<Scene> = Vec::new();
        if model.depends_on_speed() {
            scenes.push(eigenvalues(load()));
        }
        scenes.extend(draw_side_view(&load()).map(|(scene, _)| scene));
        scenes.extend(Changes::new(load()).ok().and_then(|changes| draw_tornado(&changes)));
        for scene in &scenes {
            count += 1;
            assert!(scene.width > 0.0 && scene.height > 0.0 && !scene.title.is_empty());
            for text in texts(scene).chain([scene.title.as_str()]) {
                assert!(font::has(text), "{}: {text}", scene.title);
            }
        }
    }
    assert!(count > MODELS.len());
    for parameter in MODELS.iter().flat_map(|model| model.info.parameters) {
        assert!(font::has(parameter.symbol) && font::has(&carvallo_design::number::unit(parameter.unit)));
    }
}
