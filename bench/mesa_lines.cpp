// SPDX-License-Identifier: Apache-2.0
#include "mesa_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace kushi::bench {

namespace {

constexpr const char* sceneVertex = R"(#version 330
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 color;
uniform mat4 camera;
out vec3 light;
void main() { gl_Position = camera * vec4(place, 1); light = color; }
)";
constexpr const char* sceneFragment = R"(#version 330
in vec3 light;
out vec4 pixel;
void main() { pixel = vec4(light, 1); }
)";

// A triangle over the whole picture, whose pixels each average side x side samples.
constexpr const char* averageVertex = R"(#version 330
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }
)";
constexpr const char* averageFragment = R"(#version 330
uniform sampler2D samples;
uniform int side;
out vec4 pixel;
void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * side;
    vec3 sum = vec3(0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            sum += texelFetch(samples, first + ivec2(x, y), 0).rgb;
    pixel = vec4(sum / float(side * side), 1);
}
)";

GLuint programOf(const char* vertex, const char* fragment) {
    const GLuint program = glCreateProgram();
    for (const auto& [kind, text] :
         {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
        const GLuint shader = glCreateShader(static_cast<GLenum>(kind));
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    return program;
}

/// From the world to OpenGL's clip space, column by column; sees as far as `far` [m].
std::array<float, 16> matrixOf(const Camera& camera, double far) {
    const Vec3d view = camera.target.as<double>() - camera.eye.as<double>();
    const double near = 1e-3 * length(view);
    const Vec3d forward = normalized(view);
    const Vec3d right = normalized(cross(forward, camera.up.as<double>()));
    const Vec3d up = cross(right, forward);
    const double focal = 1 / std::tan(0.5 * camera.verticalFieldOfView);
    const double a = (far + near) / (far - near);
    const double b = -2 * far * near / (far - near);
    const std::array<Vec3d, 4> rows = {focal * right, focal * up, a * forward, forward};
    const std::array<double, 4> shift = {0, 0, b, 0};
    std::array<float, 16> matrix{};
    for (std::size_t row = 0; row < 4; ++row) {
        const auto r = rows[row];
        matrix[row] = static_cast<float>(r.x);
        matrix[4 + row] = static_cast<float>(r.y);
        matrix[8 + row] = static_cast<float>(r.z);
        matrix[12 + row] = static_cast<float>(shift[row] - dot(r, camera.eye.as<double>()));
    }
    return matrix;
}

/// Vertices of colour and place in the graphics memory, and how they are joined.
struct Shape {
    GLuint array = 0;
    GLsizei count = 0;
};

Shape shapeOf(std::span<const Vec3f> places, std::span<const Rgb> colors,
              std::span<const std::uint32_t> indices) {
    Shape shape = {.count = static_cast<GLsizei>(indices.size())};
    glGenVertexArrays(1, &shape.array);
    glBindVertexArray(shape.array);
    std::array<GLuint, 3> buffers{};
    glGenBuffers(3, buffers.data());

    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(places.size_bytes()), places.data(),
                 GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), nullptr);
    glEnableVertexAttribArray(0);

    glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(colors.size_bytes()), colors.data(),
                 GL_STATIC_DRAW);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Rgb), nullptr);
    glEnableVertexAttribArray(1);

    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()),
                 indices.data(), GL_STATIC_DRAW);
    return shape;
}

Shape linesOf(const Strands& strands, std::span<const Rgb> colors) {
    std::vector<std::uint32_t> indices;
    for (std::size_t strand = 0; strand < strands.size(); ++strand) {
        for (std::uint32_t i = strands.offsets[strand]; i + 1 < strands.offsets[strand + 1]; ++i)
            indices.insert(indices.end(), {i, i + 1});
    }
    return shapeOf(strands.nodes, colors, indices);
}

Shape trianglesOf(const Mesh& mesh) {
    std::vector<std::uint32_t> indices;
    for (const auto& triangle : mesh.triangles)
        indices.insert(indices.end(), triangle.begin(), triangle.end());
    return shapeOf(mesh.vertices, mesh.colors, indices);
}

/// A picture to draw into: 8 bits a channel, which is what the rasteriser is fastest at.
struct Target {
    GLuint framebuffer = 0, color = 0;
    int size = 0;

    Target(int side, bool withDepth) : size(side) {
        glGenFramebuffers(1, &framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glGenTextures(1, &color);
        glBindTexture(GL_TEXTURE_2D, color);
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, size, size);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
        if (!withDepth) return;
        GLuint depth = 0;
        glGenRenderbuffers(1, &depth);
        glBindRenderbuffer(GL_RENDERBUFFER, depth);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size, size);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    }

    void begin() const {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glViewport(0, 0, size, size);
    }
};

/// A context without a display; gone with its owner.
class Context {
public:
    Context() {
        display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == 0) return;
        eglBindAPI(EGL_OPENGL_API);
        const std::array<EGLint, 7> wish = {EGL_CONTEXT_MAJOR_VERSION,
                                            4,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            3,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_NONE};
        context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wish.data());
        use();
    }
    ~Context() {
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    bool use() const {
        return context_ != EGL_NO_CONTEXT &&
               eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != 0;
    }

private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

/// What the graphics memory holds.
struct MesaLines::State {
    Context context;
    std::string problem, renderer;
    int size = 0, supersample = 1;
    Rgb background;
    std::array<float, 16> matrix{};
    GLuint drawing = 0, averaging = 0;
    Shape lines, triangles, wholePicture;
    std::unique_ptr<Target> samples, pixels;
};

MesaLines::MesaLines(const Wig& wig, int size, int supersample, Rgb background)
    : state_(std::make_unique<State>()) {
    State& state = *state_;
    if (!state.context.use()) {
        state.problem = "no OpenGL 4.3 without a display here";
        return;
    }
    // What a caller may write into: glGetString is of the driver.
    const auto* name = glGetString(GL_RENDERER);
    for (; name != nullptr && *name != 0; ++name)
        state.renderer += static_cast<char>(*name);
    state.size = size;
    state.supersample = supersample;
    state.background = background;
    state.matrix = matrixOf(wig.camera, 10 * length(wig.camera.target - wig.camera.eye));
    state.drawing = programOf(sceneVertex, sceneFragment);
    state.averaging = programOf(averageVertex, averageFragment);
    state.lines = linesOf(wig.strands, wig.colors);
    state.triangles = trianglesOf(wig.head);
    glGenVertexArrays(1, &state.wholePicture.array);
    state.samples = std::make_unique<Target>(size * supersample, true);
    state.pixels = std::make_unique<Target>(size, false);
    if (glGetError() != GL_NO_ERROR) state.problem = "OpenGL refuses the scene";
}

MesaLines::~MesaLines() = default;

const std::string& MesaLines::problem() const {
    return state_->problem;
}

const std::string& MesaLines::renderer() const {
    return state_->renderer;
}

Image MesaLines::draw() {
    const State& state = *state_;
    state.context.use();
    state.samples->begin();
    glEnable(GL_DEPTH_TEST);
    glClearColor(state.background.r, state.background.g, state.background.b, 1);
    glClear(static_cast<GLbitfield>(GL_COLOR_BUFFER_BIT) |
            static_cast<GLbitfield>(GL_DEPTH_BUFFER_BIT));
    glUseProgram(state.drawing);
    glUniformMatrix4fv(glGetUniformLocation(state.drawing, "camera"), 1, GL_FALSE,
                       state.matrix.data());
    glBindVertexArray(state.triangles.array);
    glDrawElements(GL_TRIANGLES, state.triangles.count, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(state.lines.array);
    glDrawElements(GL_LINES, state.lines.count, GL_UNSIGNED_INT, nullptr);

    if (state.supersample > 1) {
        state.pixels->begin();
        glDisable(GL_DEPTH_TEST);
        glUseProgram(state.averaging);
        glUniform1i(glGetUniformLocation(state.averaging, "side"), state.supersample);
        glBindTexture(GL_TEXTURE_2D, state.samples->color);
        glBindVertexArray(state.wholePicture.array);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    // OpenGL's first row is the lowest.
    const auto side = static_cast<std::size_t>(state.size);
    std::vector<std::uint8_t> bytes(side * side * 4);
    glReadPixels(0, 0, state.size, state.size, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    Image image{.width = state.size, .height = state.size, .pixels = {}};
    image.pixels.reserve(side * side);
    for (std::size_t row = side; row-- > 0;) {
        const std::uint8_t* byte = bytes.data() + row * side * 4;
        for (std::size_t i = 0; i < side; ++i, byte += 4) {
            const auto channel = [&](int c) { return static_cast<float>(byte[c]) / 255.0F; };
            image.pixels.push_back({channel(0), channel(1), channel(2)});
        }
    }
    return image;
}

}  // namespace kushi::bench
