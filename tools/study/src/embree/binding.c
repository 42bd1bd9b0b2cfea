/* Builds a mesh and casts rays at it one by one, following Embree's manual. */
#include <math.h>
#include <string.h>
#if EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

/* Three corners for each triangle. Triangles share none, which changes nothing for Embree: it copies
   them to leaves. */
RTCScene pinhole_embree_build(const float *corners, unsigned triangle_count) {
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *to = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                        3 * sizeof(float), 3 * triangle_count);
    memcpy(to, corners, 9 * sizeof(float) * triangle_count);
    unsigned *indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                                                RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
                                                triangle_count);
    for (unsigned at = 0; at < 3 * triangle_count; at++)
        indices[at] = at;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}

void pinhole_embree_cast(RTCScene scene, const float (*rays)[6], unsigned count, float *t) {
#if EMBREE == 3
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
#endif
    for (unsigned at = 0; at < count; at++) {
        const float *ray = rays[at];
        struct RTCRayHit asked = {
            .ray = {.org_x = ray[0], .org_y = ray[1], .org_z = ray[2],
                    .dir_x = ray[3], .dir_y = ray[4], .dir_z = ray[5],
                    .tnear = 0, .tfar = INFINITY, .mask = -1},
            .hit = {.geomID = RTC_INVALID_GEOMETRY_ID, .instID = {RTC_INVALID_GEOMETRY_ID}},
        };
#if EMBREE == 3
        rtcIntersect1(scene, &context, &asked);
#else
        rtcIntersect1(scene, &asked, 0);
#endif
        t[at] = asked.hit.geomID == RTC_INVALID_GEOMETRY_ID ? INFINITY : asked.ray.tfar;
    }
}
