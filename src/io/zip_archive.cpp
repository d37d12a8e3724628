#include "io/zip_archive.hpp"

#include <vector>

#include <zip.h>

#include "io/text_scanner.hpp"

namespace moldlight {

namespace {

// Meshes in XML shrink to a tenth or so; what shrinks to less than a hundredth is no mesh.
constexpr std::uint64_t k_free_bytes = std::uint64_t{100} << 20;
constexpr std::uint64_t k_max_expansion = 100;
constexpr std::size_t k_unpacked_bytes = std::size_t{64} << 10;

std::string zip_error_text(zip_error_t& error) {
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

}  // namespace

ZipArchive::ZipArchive(const ReadContext& context)
    : context_(context),
      archive_(nullptr, [](zip* archive) { zip_discard(archive); }),
      bytes_left_(k_free_bytes + k_max_expansion * context.bytes().size()) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(context.bytes().data(), context.bytes().size(), 0, &error);
  if (source == nullptr) context.fail("", "cannot be unpacked: {}", zip_error_text(error));
  archive_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
  if (archive_ == nullptr) {
    zip_source_free(source);
    context.fail("", "is a damaged or cut zip archive ({}); export the part again", zip_error_text(error));
  }
}

std::int64_t ZipArchive::find(const std::string& entry) const {
  const std::int64_t exact = zip_name_locate(archive_.get(), entry.c_str(), 0);
  return exact >= 0 ? exact : zip_name_locate(archive_.get(), entry.c_str(), ZIP_FL_NOCASE);
}

void ZipArchive::read(const std::string& entry, const std::function<void(std::string_view)>& sink) {
  const std::int64_t index = find(entry);
  if (index < 0) context_.fail("", "the archive holds no {}; export the part again", in_quotes(entry));
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
      zip_fopen_index(archive_.get(), static_cast<zip_uint64_t>(index), 0), zip_fclose);
  if (file == nullptr) {
    context_.fail(in_quotes(entry), "cannot be unpacked: {}",
                  zip_error_strerror(zip_get_error(archive_.get())));
  }
  std::vector<char> chunk(k_unpacked_bytes);
  while (true) {
    const zip_int64_t got = zip_fread(file.get(), chunk.data(), chunk.size());
    if (got < 0) {
      context_.fail(in_quotes(entry), "is damaged: {}; export the part again",
                    zip_error_strerror(zip_file_get_error(file.get())));
    }
    if (got == 0) return;
    const auto size = static_cast<std::uint64_t>(got);
    if (size > bytes_left_) {
      context_.fail(in_quotes(entry), "expands to more than {} times the file's size, as no real part does",
                    k_max_expansion);
    }
    bytes_left_ -= size;
    sink({chunk.data(), static_cast<std::size_t>(size)});
  }
}

}  // namespace moldlight
