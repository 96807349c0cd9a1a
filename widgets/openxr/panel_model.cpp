#include "widgets/openxr/panel_model.h"

#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Depth>
#include <osg/Geometry>

#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

/// Samples along a picture that is seen at an angle.
constexpr float kAnisotropy = 8.0F;

osg::ref_ptr<osg::Texture2D> makeTexture() {
  osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
  texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
  texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
  texture->setMaxAnisotropy(kAnisotropy);
  texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
  texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
  texture->setResizeNonPowerOfTwoHint(false);
  return texture;
}

/// A square of side 1 about the origin, in x and y. The first row of the picture is at the top.
osg::ref_ptr<osg::Geometry> makeSheet(osg::Texture2D* texture, PanelModel::Kind kind) {
  osg::ref_ptr<osg::Geometry> sheet = osg::createTexturedQuadGeometry(
      osg::Vec3(-0.5F, -0.5F, 0.0F), osg::Vec3(1.0F, 0.0F, 0.0F), osg::Vec3(0.0F, 1.0F, 0.0F), 0.0F, 1.0F, 1.0F, 0.0F);
  osg::StateSet* state = sheet->getOrCreateStateSet();
  state->setTextureAttributeAndModes(0, texture);
  state->setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
  makeUnlit(*sheet);
  const bool isPanel = kind == PanelModel::Kind::Panel;
  state->setRenderBinDetails(isPanel ? PanelModel::kBin : PanelModel::kBin - 1, "RenderBin");
  // Nothing hides a panel but what is drawn after it: the hands, which are before or behind it.
  state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, isPanel));
  if (isPanel) return sheet;
  state->setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA));
  return sheet;
}

}  // namespace

PanelModel::PanelModel(Kind kind) : placed_(new osg::MatrixTransform), texture_(makeTexture()) {
  placed_->addChild(makeSheet(texture_, kind));
  placed_->setNodeMask(0U);
}

void PanelModel::show(const ShownPicture& shown, double metre) {
  placed_->setNodeMask(shown.X_WP && shown.picture ? ~0U : 0U);
  if (!shown.X_WP || !shown.picture) return;
  placed_->setMatrix(osg::Matrixd::scale(shown.width * metre, shown.height * metre, metre) * toOsg(*shown.X_WP));
  if (shown.picture == picture_) return;
  picture_ = shown.picture;
  // The image refers to the picture's pixels, which `picture_` keeps until the next picture.
  const osg::ref_ptr<osg::Image> image = new osg::Image;
  image->setImage(picture_->width, picture_->height, 1, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE,
                  const_cast<unsigned char*>(picture_->rgba.data()), osg::Image::NO_DELETE);
  texture_->setImage(image);
}

}  // namespace glissade
