#pragma once

#include "app/render/camera.h"
#include "app/render/canvas.h"
#include "app/render/stage.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::render {

// Draws stages. The same in a window and off screen: it needs an OpenGL 3.3 core context, current
// on the calling thread from create() to the renderer's end, and leaves no state behind that others
// have to know but the bound framebuffer.
//
// Light: a sun with a soft shadow, a sky that fills in and that a plant's inside sees less of
// (sky_visibility.h), light that shines through leaves and petals. Materials show their colour's
// picture and its mask; without one, bark and veins are made of the texture coordinates. The same
// stage gives the same pixels each time.
class Renderer {
public:
    // Fails, as the station's fault, if the driver does not take the shaders.
    static Result<Renderer> create();

    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    // Draws over the whole canvas and resolves it.
    void draw(Stage const& stage, Camera const& camera, Canvas const& canvas);

    // Draws a picture as a value. Pixels; both at least 1.
    Image picture(Stage const& stage, Camera const& camera, int width, int height);

private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts>);

    std::unique_ptr<Parts> parts_;
};

} // namespace tractus::render
