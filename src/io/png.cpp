// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.h"

#include <kushi/image.h>
#include <kushi/layered_image.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <new>
#include <span>

#include <png.h>

namespace kushi {
namespace {

/// Linear light to the nearest 8-bit code (IEC 61966-2-1).
class SrgbEncoder {
public:
    SrgbEncoder() {
        for (std::size_t code = 0; code < thresholds_.size(); ++code) {
            const double s = (static_cast<double>(code) + 0.5) / 255;
            const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
            thresholds_[code] = static_cast<float>(linear);
        }
        for (std::size_t cell = 0; cell < start_.size(); ++cell) {
            start_[cell] = search(static_cast<float>(cell) / cells);
        }
    }

    png_byte operator()(float linear) const {
        if (!(linear > 0)) return 0;  // also what is not a number
        if (linear >= 1) return 255;
        std::size_t code = start_[static_cast<std::size_t>(linear * cells)];
        while (code < thresholds_.size() && linear >= thresholds_[code])
            ++code;
        return static_cast<png_byte>(code);
    }

private:
    static constexpr int cells = 1024;

    png_byte search(float linear) const {
        return static_cast<png_byte>(std::ranges::upper_bound(thresholds_, linear) -
                                     thresholds_.begin());
    }

    std::array<float, 255> thresholds_{};  // where code k + 1 begins
    std::array<png_byte, cells> start_{};  // code at the lower end of each cell
};

/// Owns the state of libpng, which neither prints nor ends the program.
class PngState {
public:
    PngState() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore)) {
        if (png_ != nullptr) info_ = png_create_info_struct(png_);
    }
    PngState(const PngState&) = delete;
    PngState& operator=(const PngState&) = delete;
    ~PngState() { png_destroy_write_struct(&png_, &info_); }

    png_structp png() const { return png_; }
    png_infop info() const { return info_; }

private:
    [[noreturn]] static void fail(png_structp png, png_const_charp) { png_longjmp(png, 1); }
    static void ignore(png_structp, png_const_charp) {}

    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

void appendBytes(png_structp png, png_bytep bytes, png_size_t size) {
    auto* out = static_cast<std::string*>(png_get_io_ptr(png));
    bool full = false;
    try {
        out->append(reinterpret_cast<const char*>(bytes), size);
    } catch (const std::bad_alloc&) {
        full = true;  // no exception may pass through libpng
    }
    if (full) png_error(png, "out of memory");
}

/// Everything with a destructor lives in the caller: libpng leaves by longjmp.
///
/// alpha  of each pixel, in which its colour is multiplied in; or null
bool encode(const PngState& state, const Image& image, const float* const alpha,
            const SrgbEncoder& srgb, png_byte* row, std::string* out) {
    png_structp png = state.png();
    png_infop info = state.info();
    if (png == nullptr || info == nullptr) return false;
    if (setjmp(png_jmpbuf(png)) != 0) return false;

    png_set_write_fn(png, out, appendBytes, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
                 static_cast<png_uint_32>(image.height), 8,
                 alpha != nullptr ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_compression_level(png, 3);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FAST_FILTERS);
    png_write_info(png, info);
    for (int y = 0; y < image.height; ++y) {
        png_byte* byte = row;
        for (int x = 0; x < image.width; ++x) {
            const Rgb& pixel = image.at(x, y);
            const auto place = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(x);
            const float share = alpha != nullptr ? alpha[place] : 1;
            const float scale = share > 0 ? 1 / share : 0;
            for (const float channel : {pixel.r, pixel.g, pixel.b})
                *byte++ = srgb(channel * scale);
            if (alpha != nullptr)
                *byte++ = static_cast<png_byte>(std::lround(255 * std::clamp(share, 0.0F, 1.0F)));
        }
        png_write_row(png, row);
    }
    png_write_end(png, nullptr);
    return true;
}

/// alpha  as many as pixels, or none
Status write(const Image& image, std::span<const float> alpha, const std::string& path) try {
    constexpr int most = PNG_USER_WIDTH_MAX;
    const auto pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.width < 1 || image.height < 1 || image.width > most || image.height > most ||
        image.pixels.size() != pixels) {
        return Problem{.message = "a picture of " + std::to_string(image.width) + " x " +
                                  std::to_string(image.height) + " with " +
                                  std::to_string(image.pixels.size()) +
                                  " pixels cannot be written as PNG",
                       .file = path};
    }
    const PngState state;
    const SrgbEncoder srgb;
    std::vector<png_byte> row(4 * static_cast<std::size_t>(image.width));
    std::string bytes;
    if (!encode(state, image, alpha.empty() ? nullptr : alpha.data(), srgb, row.data(), &bytes)) {
        return Problem{
            .message = "not enough memory for this picture", .file = path, .system = true};
    }
    return writeFileAtomically(path, bytes);
} catch (const std::bad_alloc&) {
    return Problem{.message = "not enough memory for this picture", .file = path, .system = true};
}

}  // namespace

Status writePng(const Image& image, const std::string& path) {
    return write(image, {}, path);
}

Status writePng(const LayeredImage& image, const std::string& path) {
    if (image.alpha.size() != image.image.pixels.size()) {
        return Problem{.message = "a picture whose alpha has another size cannot be written as PNG",
                       .file = path};
    }
    return write(image.image, image.alpha, path);
}

}  // namespace kushi
