# SPDX-License-Identifier: Apache-2.0
# Types of the module cdsm for editors and checkers; docs/python.md explains, help(cdsm) describes each name.
from typing import Any, Callable, Iterable, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

Vec3 = Union[Sequence[float], NDArray[Any]]
Floats = NDArray[np.float32]
Indices = NDArray[np.uint32]

class Error(RuntimeError): ...
class DeviceError(Error): ...

class Camera:
    position: Vec3
    target: Vec3
    up: Vec3
    fov: float
    def __init__(self, *, position: Vec3 = ..., target: Vec3 = ..., up: Vec3 = ..., fov: float = ...) -> None: ...

class ImageSettings:
    width: int
    height: int
    background: Vec3
    ambient: Vec3
    supersampling: int
    def __init__(self, *, width: int = ..., height: int = ..., background: Vec3 = ..., ambient: Vec3 = ...,
                 supersampling: int = ...) -> None: ...

class ShadowSettings:
    technique: str
    memory: str
    max_nodes: int
    node_format: str
    map_size: int
    tolerance: float
    tolerance_mode: str
    filter: str
    rays: str
    transmittance: str
    threshold: float
    pcf: int
    samples: int
    patch: int
    softness: float
    softness_distance: float
    softness_exponent: float
    seed: int
    stratified: bool
    clusters: int
    cluster_distance: float
    stable: bool
    step: float
    memory_limit_mb: float
    cache: str
    on_overflow: str
    bias: float
    def __init__(self, *, technique: str = ..., memory: str = ..., max_nodes: int = ..., node_format: str = ...,
                 map_size: int = ..., tolerance: float = ..., tolerance_mode: str = ..., filter: str = ...,
                 rays: str = ..., transmittance: str = ..., threshold: float = ..., pcf: int = ..., samples: int = ...,
                 patch: int = ..., softness: float = ...,
                 softness_distance: float = ..., softness_exponent: float = ..., seed: int = ...,
                 stratified: bool = ..., clusters: int = ..., cluster_distance: float = ..., stable: bool = ...,
                 step: float = ..., memory_limit_mb: float = ..., cache: str = ..., on_overflow: str = ...,
                 bias: float = ...) -> None: ...

class AmbientOcclusion:
    directions: int
    distance: float
    resolution: int
    strength: float
    def __init__(self, *, directions: int = ..., distance: float = ..., resolution: int = ...,
                 strength: float = ...) -> None: ...

class Light:
    name: str
    type: str
    position: Vec3
    target: Vec3
    direction: Vec3
    cutoff: float
    color: Vec3
    def __init__(self, *, name: str = ..., type: str = ..., position: Vec3 = ..., target: Vec3 = ...,
                 direction: Vec3 = ..., cutoff: float = ..., color: Vec3 = ...) -> None: ...

class Material:
    name: str
    diffuse: Vec3
    specular: Vec3
    shininess: float
    opacity: float
    transmission: Vec3
    def __init__(self, *, name: str = ..., diffuse: Vec3 = ..., specular: Vec3 = ..., shininess: float = ...,
                 opacity: float = ..., transmission: Vec3 = ...) -> None: ...

class Mesh:
    name: str
    positions: Optional[Floats]
    normals: Optional[Floats]
    triangles: Optional[Indices]
    revision: int
    material: Optional[Material]
    world_from_object: ArrayLike
    interior_extinction: float
    interior_color: Vec3
    interior_transmission: Vec3
    casts: bool
    receives: bool
    weight: float
    def __init__(self, *, name: str = ..., positions: Optional[Floats] = ..., normals: Optional[Floats] = ...,
                 triangles: Optional[Indices] = ..., revision: int = ..., material: Optional[Material] = ...,
                 world_from_object: ArrayLike = ..., interior_extinction: float = ..., interior_color: Vec3 = ...,
                 interior_transmission: Vec3 = ..., casts: bool = ..., receives: bool = ...,
                 weight: float = ...) -> None: ...

class Spheres:
    name: str
    centers: Optional[Floats]
    radii: Optional[Floats]
    colors: Optional[Floats]
    revision: int
    material: Optional[Material]
    world_from_object: ArrayLike
    casts: bool
    receives: bool
    weight: float
    def __init__(self, *, name: str = ..., centers: Optional[Floats] = ..., radii: Optional[Floats] = ...,
                 colors: Optional[Floats] = ..., revision: int = ..., material: Optional[Material] = ...,
                 world_from_object: ArrayLike = ..., casts: bool = ..., receives: bool = ...,
                 weight: float = ...) -> None: ...

class TransferFunction:
    opacity: ArrayLike
    shadow_opacity: ArrayLike
    color: ArrayLike
    transmission: ArrayLike
    unit_distance: float
    def __init__(self, *, opacity: ArrayLike = ..., shadow_opacity: ArrayLike = ..., color: ArrayLike = ...,
                 transmission: ArrayLike = ..., unit_distance: float = ...) -> None: ...

class Volume:
    name: str
    voxels: Optional[NDArray[Any]]
    object_from_index: ArrayLike
    revision: int
    transfer: Optional[TransferFunction]
    boundary: Optional[Mesh]
    world_from_object: ArrayLike
    specular: Vec3
    shininess: float
    shading: bool
    casts: bool
    receives: bool
    weight: float
    def __init__(self, *, name: str = ..., voxels: NDArray[Any] = ..., object_from_index: ArrayLike = ...,
                 revision: int = ..., transfer: Optional[TransferFunction] = ..., boundary: Optional[Mesh] = ...,
                 world_from_object: ArrayLike = ..., specular: Vec3 = ..., shininess: float = ..., shading: bool = ...,
                 casts: bool = ..., receives: bool = ..., weight: float = ...) -> None: ...

class Scene:
    camera: Optional[Camera]
    image: Optional[ImageSettings]
    shadows: Optional[ShadowSettings]
    lights: list[Light]
    meshes: list[Mesh]
    volumes: list[Volume]
    spheres: list[Spheres]
    ambient_occlusion: Optional[AmbientOcclusion]
    def __init__(self, *, camera: Optional[Camera] = ..., image: Optional[ImageSettings] = ...,
                 shadows: Optional[ShadowSettings] = ..., lights: Iterable[Light] = ..., meshes: Iterable[Mesh] = ...,
                 volumes: Iterable[Volume] = ..., spheres: Iterable[Spheres] = ...,
                 ambient_occlusion: Optional[AmbientOcclusion] = ...) -> None: ...

class LightMap:
    @property
    def cluster(self) -> int: ...
    @property
    def number(self) -> int: ...
    @property
    def objects(self) -> list[str]: ...
    @property
    def side(self) -> str: ...
    @property
    def share(self) -> float: ...
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def near_depth(self) -> float: ...
    @property
    def far_depth(self) -> float: ...
    @property
    def picture_from_world(self) -> Floats: ...
    @property
    def camera_from_world(self) -> Floats: ...
    @property
    def first_node(self) -> Indices: ...
    @property
    def nodes(self) -> Floats: ...
    @property
    def colors(self) -> Optional[Floats]: ...

class Engine:
    def __init__(self, device: str = "", fetch: str = "auto", *,
                 progress: Optional[Callable[[str, float], Any]] = None,
                 warning: Optional[Callable[[str], Any]] = None) -> None: ...
    @property
    def device(self) -> dict[str, Any]: ...
    @property
    def stats(self) -> dict[str, Any]: ...
    def render(self, scene: Scene, out: Optional[Floats] = None) -> Floats: ...
    def view(self, scene: Scene, view: str, light: Optional[str] = None) -> Floats: ...
    def prepare(self, scene: Scene) -> None: ...
    def transmittance(self, light: str, points: Floats, out: Optional[Floats] = None) -> Floats: ...
    def light_maps(self, scene: Scene, light: str) -> list[LightMap]: ...
    def drop(self) -> None: ...

def validate(scene: Scene) -> None: ...
def list_devices() -> list[dict[str, Any]]: ...
