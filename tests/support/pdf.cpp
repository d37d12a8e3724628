#include "support/pdf.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>

#include <gtest/gtest.h>

#include "support/process.hpp"
#include "support/program_path.hpp"
#include "support/read_png.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight::test {

namespace {

std::string run_reader(const char* program, std::vector<std::string> words) {
  words.insert(words.begin(), program_path({program}));
  Process process(words, {});
  const ProcessResult result = process.finish();
  EXPECT_EQ(result.exit_code, 0) << program << ": " << result.err;
  EXPECT_EQ(result.err, "") << program;
  return result.out;
}

/// The five entities that the reader writes.
std::string plain(std::string text) {
  for (const auto& [entity, letter] :
       {std::pair("&lt;", "<"), std::pair("&gt;", ">"), std::pair("&quot;", "\""), std::pair("&#39;", "'"),
        std::pair("&apos;", "'"), std::pair("&amp;", "&")}) {
    for (std::size_t at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1))
      text.replace(at, std::string_view(entity).size(), letter);
  }
  return text;
}

}  // namespace

bool has_pdf_reader() { return !program_path({"pdftotext"}).empty() && !program_path({"pdftoppm"}).empty(); }

std::vector<PdfPage> pdf_pages(std::string_view pdf) {
  const ScratchFolder folder;
  const std::string text = run_reader("pdftotext", {"-bbox", folder.write("a.pdf", pdf), "-"});
  static const std::regex k_line(
      R"re(<page width="([^"]+)" height="([^"]+)">|<word xMin="([^"]+)" yMin="([^"]+)" xMax="([^"]+)" yMax="([^"]+)">([^<]*)</word>)re");
  std::vector<PdfPage> pages;
  for (std::sregex_iterator it(text.begin(), text.end(), k_line), end; it != end; ++it) {
    const std::smatch& match = *it;
    const auto number = [&match](std::size_t k) { return std::stod(match[k]); };
    if (match[1].matched) pages.push_back({{number(1), number(2)}, {}});
    if (match[3].matched)
      pages.back().words.push_back({plain(match[7]), {number(3), number(4)}, {number(5), number(6)}});
  }
  return pages;
}

std::string pdf_info(std::string_view pdf) {
  const ScratchFolder folder;
  return run_reader("pdfinfo", {folder.write("a.pdf", pdf)});
}

std::string pdf_fonts(std::string_view pdf) {
  const ScratchFolder folder;
  return run_reader("pdffonts", {folder.write("a.pdf", pdf)});
}

std::vector<Image> pdf_pictures(std::string_view pdf) {
  const ScratchFolder folder;
  static_cast<void>(
      run_reader("pdftoppm", {"-r", "72", "-png", folder.write("a.pdf", pdf), folder.file("page")}));
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    if (entry.path().extension() == ".png") files.push_back(entry.path().string());
  std::ranges::sort(files);
  std::vector<Image> pictures;
  for (const std::string& file : files) pictures.push_back(read_png(file));
  return pictures;
}

}  // namespace moldlight::test
