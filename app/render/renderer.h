#pragma once

#include "app/render/camera.h"
#include "app/render/canvas.h"
#include "app/render/stage.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::render {

// Draws stages, in a window or off screen. It needs an OpenGL 3.3 core context that is current on
// the calling thread from create() until the renderer is destroyed. Of the state that other users
// of the context rely on, it changes only the bound framebuffer. Lighting: a sun with a soft
// shadow, ambient light from the sky that is attenuated inside a plant (sky_visibility.h), and
// light that shines through leaves and petals. Materials show their colour picture and its mask;
// without pictures, bark and leaf veins are procedural. Rendering is deterministic.
class Renderer {
public:
    // Fails with an internal error if the driver rejects the shaders.
    static Result<Renderer> create();

    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    // Draws the stage over the whole canvas and resolves the canvas.
    void draw(Stage const& stage, Camera const& camera, Canvas const& canvas);

    // Renders the stage to an image. `width` and `height` are in pixels, at least 1.
    Image picture(Stage const& stage, Camera const& camera, int width, int height);

private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts>);

    std::unique_ptr<Parts> parts_;
};

} // namespace tractus::render
