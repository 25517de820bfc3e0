// SPDX-License-Identifier: Apache-2.0
#include "io/file_limit.h"
#include "io/text.h"

#include <kushi/image.h>

#include <array>
#include <csetjmp>
#include <cstring>
#include <new>
#include <string_view>

#include <png.h>

namespace kushi {
namespace {

constexpr std::size_t mostPixels = std::size_t{8192} * 8192;

/// Bytes that libpng takes one after the other.
struct Source {
    std::string_view bytes;
};

/// Owns the state of libpng, which neither prints nor ends the program.
class PngReader {
public:
    explicit PngReader(Source& source)
        : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore)) {
        if (png_ == nullptr) throw std::bad_alloc();
        info_ = png_create_info_struct(png_);
        if (info_ == nullptr) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(png_, &source, take);
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

    // Nothing with a destructor may live in these two: libpng leaves by longjmp.

    /// Asks for grey and alpha of 16 bits, whatever the file has.
    bool readHeader() {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_read_info(png_, info_);
        png_set_expand_16(png_);
        png_set_rgb_to_gray_fixed(png_, PNG_ERROR_ACTION_NONE, 21260, 71520);
        png_set_add_alpha(png_, 0xFFFF, PNG_FILLER_AFTER);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }
    bool readRows(png_bytepp rows) {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_read_image(png_, rows);
        return true;
    }

    std::size_t width() const { return png_get_image_width(png_, info_); }
    std::size_t height() const { return png_get_image_height(png_, info_); }
    std::size_t rowBytes() const { return png_get_rowbytes(png_, info_); }

private:
    [[noreturn]] static void fail(png_structp png, png_const_charp) { png_longjmp(png, 1); }
    static void ignore(png_structp, png_const_charp) {}
    static void take(png_structp png, png_bytep out, png_size_t size) {
        auto* source = static_cast<Source*>(png_get_io_ptr(png));
        if (size > source->bytes.size()) png_error(png, "cut short");
        std::memcpy(out, source->bytes.data(), size);
        source->bytes.remove_prefix(size);
    }

    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

std::uint16_t bigEndian(const png_byte* bytes) {
    return static_cast<std::uint16_t>(bytes[0] << 8U | bytes[1]);
}

}  // namespace

Result<GreyImage> readGreyPng(const std::string& path) try {
    const Result<std::string> bytes = readLimitedFile(path, mostBytes);
    if (!bytes) return bytes.problems();
    Source source = {*bytes};
    PngReader reader(source);
    if (!reader.readHeader()) return badFile(path, "not a PNG, or a damaged one");
    const std::size_t width = reader.width();
    const std::size_t height = reader.height();
    if (width * height > mostPixels) {
        return badFile(path, "a picture of " + std::to_string(width) + " x " +
                                 std::to_string(height) + " pixels, expected 8192 x 8192 at most");
    }
    const std::size_t rowBytes = reader.rowBytes();
    std::vector<png_byte> pixels(rowBytes * height);
    std::vector<png_bytep> rows(height);
    for (std::size_t y = 0; y < height; ++y)
        rows[y] = pixels.data() + y * rowBytes;
    if (!reader.readRows(rows.data())) return badFile(path, "the picture is damaged or cut short");

    GreyImage image = {static_cast<int>(width), static_cast<int>(height), {}};
    image.pixels.resize(width * height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const std::uint32_t grey = bigEndian(&pixels[4 * i]);
        const std::uint32_t alpha = bigEndian(&pixels[4 * i + 2]);
        image.pixels[i] = static_cast<std::uint16_t>(grey * alpha / 65535);
    }
    return image;
} catch (const std::bad_alloc&) {
    return Problem{.message = "not enough memory for this picture", .file = path, .system = true};
}

}  // namespace kushi
