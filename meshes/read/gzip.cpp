#include "meshes/read/gzip.h"

#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <memory>

#include "base/errors.h"

namespace tw {

std::string unpacked(const std::filesystem::path& file, const std::string& compressed, std::size_t largest) {
    const auto fail = [&](const std::string& what) { throw InputError(file.string() + ": " + what); };
    z_stream stream{};
    constexpr int gzip_only = 16 + MAX_WBITS;
    if (inflateInit2(&stream, gzip_only) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, inflateEnd);
    std::string content;
    std::array<char, 1 << 16> buffer;
    std::size_t taken = 0;
    while (true) {
        if (stream.avail_in == 0) {  // in pieces: zlib counts in 32 bits
            const std::size_t piece = std::min<std::size_t>(compressed.size() - taken, 1 << 30);
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data() + taken));
            stream.avail_in = static_cast<uInt>(piece);
            taken += piece;
        }
        stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
        stream.avail_out = buffer.size();
        const int state = inflate(&stream, Z_NO_FLUSH);
        content.append(buffer.data(), buffer.size() - stream.avail_out);
        if (content.size() > largest)
            fail("unpacks to more than " + std::to_string(largest) +
                 " bytes, too much for a surface of this size; unpack it yourself if it is sound");
        const bool rest = stream.avail_in > 0 || taken < compressed.size();
        if (state == Z_STREAM_END) {
            if (!rest) return content;
            inflateReset(&stream);  // members one after the other are one file
        } else if (state == Z_BUF_ERROR || (state == Z_OK && !rest && stream.avail_out > 0)) {
            fail("truncated: the compressed data end early; copy the file again");
        } else if (state != Z_OK) {
            fail(content.empty() ? "not a gzip file, or damaged; export the hull again"
                                 : "damaged gzip data; copy the file again");
        }
    }
}

MemoryFile::MemoryFile(const std::string& content) : descriptor_(memfd_create("surface", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw RunError("no memory for an unpacked surface file");
    for (std::size_t done = 0; done < content.size();) {
        const ssize_t n = write(descriptor_, content.data() + done, content.size() - done);
        if (n <= 0) {
            close(descriptor_);
            throw RunError("no memory for an unpacked surface file");
        }
        done += static_cast<std::size_t>(n);
    }
}

MemoryFile::~MemoryFile() { close(descriptor_); }

}  // namespace tw
