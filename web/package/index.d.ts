// SPDX-License-Identifier: MIT
// Types of convexact. Names of options and of entries of answers are those of the requests (docs/schema of the project).

type Rows = readonly (readonly (number | string)[])[];
/** x y z of each point: flat, or in rows. Strings are exact: "1/3". */
export type Points = Float64Array | Float32Array | Rows;
export interface Mesh {
  points: Points;
  /** Corners of each face, counter-clockwise from outside: flat triangles, or rows of three or more. */
  triangles?: Uint32Array | Int32Array | Uint16Array | readonly (readonly number[])[];
}
/** n1 n2 n3 d of each halfspace n.x + d <= 0: flat, or in rows. */
export interface Halfspaces { planes: Float64Array | Float32Array | Rows }
export type Shape = Points | Mesh | Halfspaces;
export interface Solid {
  name?: string;
  vertices: Points;
  faces?: Mesh["triangles"];
}
export type Candidate = Points | Solid | Mesh | Halfspaces | { parts: readonly (Solid | Mesh)[] };

/** A number of an answer, exact: digits, or "p/q"; small integers are numbers. */
export type Exact = number | string;
export interface Measured {
  value: number | null;
  /** Every digit is certain. */
  decimal: string;
  exact?: string;
}

export interface Options {
  /** The meaning of decimals that are strings. */
  decimal?: "nearest" | "exact";
  numbers?: "binary64" | "binary32";
  /** Whether the answer has a page (HTML) that shows it, and its title. */
  picture?: boolean;
  name?: string;
  seed?: number;
}
export interface FileOptions extends Options {
  /** Files to be made, by extension: .obj .off .ply .stl .glb .xyz .json .ine .txt; of simplify also .proof. STL and GLB
   *  hold binary32: beside another mesh they need `precision: 32`. */
  files?: string[];
  precision?: 64 | 32;
  /** Volumes as fractions, too. */
  exact_values?: boolean;
}
export interface HullOptions extends FileOptions {
  digits?: number;
  measures?: ("volume" | "area" | "mean-width" | "inertia")[];
}
export interface SimplifyOptions extends FileOptions {
  /** Halfspaces to keep, at least 4. */
  faces?: number;
  /** Such as "5%". */
  max_growth?: string | number;
  growth_of?: "volume" | "area" | "mean-width";
  cost?: "volume" | "area" | "mean-width";
  engine?: "exact" | "filtered" | "float";
  verify?: "none" | "local" | "full";
  search?: "none" | "walk" | "local" | "optimal";
  moves?: number;
  nodes?: number;
  tie_bits?: number;
  center?: string;
  /** Facets that stay: "id:12,13", "plane:0,0,1,-1", "normal:0,0,-1" or "normal:0,0,-1:10" (degrees). */
  keep?: string[];
  /** Whether the answer has every step, with its exact cost. */
  trace?: boolean;
  inner?: false;
}
/** Removes vertices of the hull, so that the solid lies inside. */
export interface InnerOptions extends Omit<FileOptions, "precision"> {
  inner: true;
  /** Vertices to keep, at least 4; or `faces`, at most so many triangles. */
  vertices?: number;
  faces?: number;
  /** Such as "5%". */
  max_loss?: string | number;
  engine?: "exact" | "filtered";
  verify?: "none" | "local" | "full";
  trace?: boolean;
}
export interface TeachOptions extends Pick<Options, "decimal" | "numbers" | "name" | "seed"> {
  /** Halfspaces to keep, at least 4. */
  faces?: number;
  cost?: "volume" | "area" | "mean-width";
  /** Further costs to show. */
  measures?: ("volume" | "area" | "mean-width")[];
  center?: string;
  precision?: 64 | 32;
  plane?: false;
}
/** In the plane: of points with one z the lesson on halfplanes, of one face the lesson on convex parts. */
export interface PlaneLessonOptions extends Pick<Options, "decimal" | "numbers" | "name"> { plane: true }
export interface VerifyOptions extends Options {
  asks?: "enclosure" | "hull" | "inner" | "simplify";
  /** Such as "1e-9", or "1e-9d" relative to the diameter. */
  tolerance?: string;
  tightness?: boolean;
  claims?: string[];
  /** Of parts: how far they may be from the solid. */
  distance?: string;
  [question: string]: unknown;
}
export interface DecomposeOptions extends Options {
  /** A share of the diameter ("3%"), or a length. */
  distance?: string | number;
  method?: "auto" | "cut" | "acd" | "hacd";
  effort?: "low" | "normal" | "high";
  max_parts?: number;
  disjoint?: boolean;
  faces?: number;
  [option: string]: unknown;
}

interface WithFiles {
  /** By name: the text of a file, and the bytes of STL and GLB. */
  files?: Record<string, string | Uint8Array>;
  picture?: string;
}
export interface Hull extends WithFiles {
  input: { points: number; hull_vertices: number; halfspaces: number };
  edges: number;
  planes: [Exact, Exact, Exact, Exact][];
  vertices: [string, string, string][];
  facets: number[][];
  /** The vertices as the nearest doubles. */
  points: Float64Array;
  box: { low: string[]; high: string[] };
  diameter: Measured;
  volume?: Measured;
  area?: Measured;
  mean_width?: Measured;
  [more: string]: unknown;
}
export interface Growth { input: Measured; output: Measured; ratio: number }
export interface Enclosure extends WithFiles {
  input: { points: number; hull_vertices: number; halfspaces: number };
  output: { halfspaces: number; reached: boolean; stop: string; planes: [Exact, Exact, Exact, Exact][]; [more: string]: unknown };
  /** n1 n2 n3 d of each halfspace, rounded outward and proven to hold every point; undefined where doubles cannot. */
  planes?: Float64Array;
  volume: Growth;
  area?: Growth;
  mean_width?: Growth;
  /** Of a request with `trace`. */
  trace?: Record<string, unknown>;
  [more: string]: unknown;
}
export interface Inner extends WithFiles {
  inner: true;
  input: { points: number; hull_vertices: number; halfspaces: number };
  /** `points` are the places of the vertices in the input. */
  output: { vertices: number; triangles: number; stop: string; points: number[]; planes: [Exact, Exact, Exact, Exact][]; [more: string]: unknown };
  volume: Growth;
  trace?: Record<string, unknown>;
  [more: string]: unknown;
}
export interface Lesson {
  /** HTML that needs no other file. */
  page: string;
  /** Chapters that a large shape has not, with reasons. */
  left_out: { chapter: string; why: string }[];
}
export interface ReadMesh {
  points: Float64Array;
  triangles: number[][];
  notes: string[];
  /** Of most formats one: to be judged as parts, `{parts: mesh.objects}`. */
  objects: { name: string; vertices: Float64Array; faces: number[][] }[];
}
export interface Claim {
  code: string;
  status: string;
  sentence: string;
  witness?: Record<string, unknown>;
  [more: string]: unknown;
}
export interface Verdict {
  /** Whether every claim holds. */
  ok: boolean;
  /** Of the first claim that does not hold. */
  sentence: string;
  verdict: "holds" | "violated" | "undecided";
  claims: Claim[];
  picture?: string;
  [more: string]: unknown;
}
export interface Decomposition {
  parts: { name?: string; vertices: number[][]; faces: number[][]; [more: string]: unknown }[];
  picture?: string;
  [more: string]: unknown;
}
export interface ConformResult {
  id: string;
  level: number;
  points: Float64Array;
  candidate?: unknown;
  ok: boolean;
  sentence: string;
  verdict?: Verdict;
}
export interface Conformance {
  ok: boolean;
  passed: number;
  results: ConformResult[];
  failures: ConformResult[];
}

/** Every method rejects with this. */
export class ConvexactError extends Error {
  /** Such as "malformed", "not-finite", "no-interior", "stopped". */
  kind: string;
  /** Of a file: counted from 1. */
  line?: number;
  sentence: string;
  /** Of an input without volume: why it has none. */
  proof?: Record<string, unknown>;
}

export interface Convexact {
  hull(shape: Shape, options?: HullOptions): Promise<Hull>;
  simplify(shape: Points | Mesh, options: InnerOptions): Promise<Inner>;
  simplify(shape: Shape, options?: SimplifyOptions): Promise<Enclosure>;
  verify(shape: Shape, candidate: Candidate, options?: VerifyOptions): Promise<Verdict>;
  decompose(mesh: Mesh, options?: DecomposeOptions): Promise<Decomposition>;
  teach(shape: Shape, options?: TeachOptions): Promise<Lesson>;
  teach(shape: Points | Mesh, options: PlaneLessonOptions): Promise<Lesson>;
  read(bytes: Uint8Array, name: string): Promise<ReadMesh | { planes: Exact[][] }>;
  conform(
    program: (points: Float64Array) => Candidate | Promise<Candidate>,
    options?: { asks?: "hull" | "enclosure"; only?: string[]; level?: 1 | 2 | 3; tolerance?: string },
  ): Promise<Conformance>;
  /** Ends what runs; what was asked rejects with the kind "stopped". */
  cancel(): void;
}

/** The double nearest to a number of an answer. */
export function toNumber(exact: Exact): number;
export default function convexact(): Promise<Convexact>;
