// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.h"

#include <kushi/layered_image.h>

#include <cstring>
#include <exception>
#include <new>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <half.h>

namespace kushi {
namespace {

/// Takes what OpenEXR writes; it goes back to fill in the places of its blocks.
class MemoryStream : public Imf::OStream {
public:
    MemoryStream() : OStream("picture") {}

    void write(const char* bytes, int size) override {
        const auto count = static_cast<std::size_t>(size);
        if (bytes_.size() < place_ + count) bytes_.resize(place_ + count);
        std::memcpy(bytes_.data() + place_, bytes, count);
        place_ += count;
    }
    std::uint64_t tellp() override { return place_; }
    void seekp(std::uint64_t place) override { place_ = place; }

    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
    std::size_t place_ = 0;
};

/// The channels of a file, and where each is in memory.
class Channels {
public:
    Channels(Imf::Header& header, int width) : header_(header), width_(width) {}

    /// first  value of the first pixel; a pixel is `stride` bytes
    void add(const char* name, Imf::PixelType type, const void* first, std::size_t stride) {
        header_.channels().insert(name, Imf::Channel(type));
        // OpenEXR reads and writes through the same kind of pointer.
        char* base = const_cast<char*>(static_cast<const char*>(first));
        buffer_.insert(name,
                       Imf::Slice(type, base, stride, stride * static_cast<std::size_t>(width_)));
    }
    const Imf::FrameBuffer& buffer() const { return buffer_; }

private:
    Imf::Header& header_;
    int width_;
    Imf::FrameBuffer buffer_;
};

struct HalfPixel {
    half r, g, b, a;
};

bool fits(const LayeredImage& layered) {
    const Image& image = layered.image;
    if (image.width < 1 || image.height < 1 || image.width > 1000000 || image.height > 1000000) {
        return false;
    }
    const auto pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto optional = [pixels](std::size_t size) { return size == 0 || size == pixels; };
    return image.pixels.size() == pixels && layered.alpha.size() == pixels &&
           optional(layered.depth.size()) && optional(layered.tangent.size()) &&
           optional(layered.strand.size()) && optional(layered.mask.size());
}

std::string encode(const LayeredImage& layered) {
    const Image& image = layered.image;
    std::vector<HalfPixel> pixels;
    pixels.reserve(image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Rgb& p = image.pixels[i];
        pixels.push_back({half(p.r), half(p.g), half(p.b), half(layered.alpha[i])});
    }

    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, Imf::Chromaticities());  // those of sRGB
    Channels channels(header, image.width);
    constexpr std::size_t size = sizeof(HalfPixel);
    channels.add("R", Imf::HALF, &pixels[0].r, size);
    channels.add("G", Imf::HALF, &pixels[0].g, size);
    channels.add("B", Imf::HALF, &pixels[0].b, size);
    channels.add("A", Imf::HALF, &pixels[0].a, size);
    if (!layered.depth.empty()) channels.add("Z", Imf::FLOAT, layered.depth.data(), sizeof(float));
    if (!layered.tangent.empty()) {
        channels.add("tangent.X", Imf::FLOAT, &layered.tangent[0].x, sizeof(Vec3f));
        channels.add("tangent.Y", Imf::FLOAT, &layered.tangent[0].y, sizeof(Vec3f));
        channels.add("tangent.Z", Imf::FLOAT, &layered.tangent[0].z, sizeof(Vec3f));
    }
    if (!layered.strand.empty())
        channels.add("id.strand", Imf::UINT, layered.strand.data(), sizeof(std::uint32_t));
    if (!layered.mask.empty())
        channels.add("mask.A", Imf::FLOAT, layered.mask.data(), sizeof(float));

    MemoryStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(channels.buffer());
        file.writePixels(image.height);
    }  // its last words are written when it goes
    return stream.bytes();
}

}  // namespace

Status writeExr(const LayeredImage& image, const std::string& path) try {
    if (!fits(image)) {
        return Problem{.message = "a picture of " + std::to_string(image.image.width) + " x " +
                                  std::to_string(image.image.height) +
                                  " whose layers have other sizes cannot be written as OpenEXR",
                       .file = path};
    }
    return writeFileAtomically(path, encode(image));
} catch (const std::bad_alloc&) {
    return Problem{.message = "not enough memory for this picture", .file = path, .system = true};
} catch (const std::exception& error) {
    return Problem{.message = std::string("cannot be written as OpenEXR: ") + error.what(),
                   .file = path,
                   .system = true};
}

}  // namespace kushi
