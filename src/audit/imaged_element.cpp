#include "audit/imaged_element.h"

#include <algorithm>
#include <sstream>

namespace viewcover {
namespace {

using flat::FlatPolygon;
using flat::Rational;

std::string text(const Rational& share) {
  std::ostringstream out;
  out << share.numerator();
  if (share.denominator() != 1) out << '/' << share.denominator();
  return out.str();
}

}  // namespace

ImagedElement::ImagedElement(const SurfacePlane& plane, ConvexPolygon element)
    : plane_(&plane), element_(std::move(element)) {}

void ImagedElement::add_parts(std::span<const FlatPolygon> seen) {
  if (pieces_.empty()) pieces_.push_back({plane_->flat(element_)});
  std::vector<Piece> before;
  before.swap(pieces_);
  std::vector<FlatPolygon> rest, outside;
  for (Piece& piece : before) {
    rest.clear();
    rest.push_back(std::move(piece.polygon));
    for (const FlatPolygon& part : seen) {
      outside.clear();
      for (FlatPolygon& polygon : rest) {
        if (polygon.is_apart_from(part)) {
          outside.push_back(std::move(polygon));
          continue;
        }
        for (const flat::FlatLine& line : part.lines()) {
          if (auto cut_off = polygon.cut(line)) outside.push_back(std::move(*cut_off));
        }
        pieces_.push_back({std::move(polygon), piece.images + 1});
      }
      rest.swap(outside);
      if (rest.empty()) break;
    }
    for (FlatPolygon& polygon : rest) pieces_.push_back({std::move(polygon), piece.images});
  }
}

std::vector<Rational> ImagedElement::shares_by_images() const {
  std::vector<Rational> shares(whole_ + 1, 0);
  if (pieces_.empty()) {
    shares.back() = 1;
    return shares;
  }
  std::vector<std::vector<const FlatPolygon*>> by_images;
  for (const Piece& piece : pieces_) {
    by_images.resize(std::max<std::size_t>(by_images.size(), piece.images + 1));
    by_images[piece.images].push_back(&piece.polygon);
  }
  const FlatPolygon element = plane_->flat(element_);
  const Rational whole = flat::twice_area(element);
  shares.resize(whole_ + by_images.size(), 0);
  for (std::size_t k = 0; k < by_images.size(); ++k) {
    if (!by_images[k].empty()) shares[whole_ + k] = flat::twice_area(by_images[k]) / whole;
  }
  return shares;
}

ElementAudit ImagedElement::result() const {
  ElementAudit audit;
  audit.area = area(element_);
  const std::vector<Rational> shares = shares_by_images();
  for (const Rational& share : shares) {
    audit.area_by_images.push_back(CGAL::to_double(share) * audit.area);
  }
  const Rational imaged = 1 - shares[0];
  audit.seen = imaged == 1   ? ElementAudit::Seen::kWholly
               : imaged == 0 ? ElementAudit::Seen::kNot
                             : ElementAudit::Seen::kInPart;
  audit.imaged_share = text(imaged);
  audit.imaged_area = CGAL::to_double(imaged) * audit.area;
  if (pieces_.empty()) audit.pieces.push_back({element_, whole_});
  for (const Piece& piece : pieces_) {
    audit.pieces.push_back({plane_->lifted(piece.polygon), whole_ + piece.images});
  }
  return audit;
}

}  // namespace viewcover
