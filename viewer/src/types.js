/**
 * The shapes of what Python tells of a figure (`rotedu.figures`), of what models compute and of what
 * the parts of the viewer hand to each other.
 *
 * @typedef {number[]} Point its three coordinates
 * @typedef {Point[]} Axes of a camera: to the right, up and back, of length 1
 * @typedef {{left: number, top: number, inside: boolean}} Place in fractions of a picture's size, and
 *   whether the picture shows it
 * @typedef {number[]} Frame left, top, width and height in fractions
 * @typedef {{from: Frame, to: Frame}} Row which part of a picture goes where in a box
 */

/**
 * What the hand can change.
 * @typedef {object} NumberInput
 * @property {"number"} kind
 * @property {number} low
 * @property {number} high
 * @property {number} step
 * @property {number | string} stride how far Step goes, or the input that says so
 * @property {number} plays seconds from low to high, or 0
 * @property {boolean} row
 * @property {string} label
 *
 * @typedef {object} BodyInput points of a sphere or orientations of bodies, one or several
 * @property {"points" | "poses"} kind
 * @property {string | string[]} names
 * @property {number} least
 * @property {number} most
 * @property {number} [length] of points, or 0 for any
 * @property {number} [reach] the handle lies at this multiple of its point
 * @property {boolean} [through] whether a point on the far side can be caught
 *
 * @typedef {{kind: "switch", label: string}} SwitchInput
 * @typedef {{kind: "choice", label: string, options: string[], words: string[]}} ChoiceInput
 * @typedef {Record<string, NumberInput | BodyInput | SwitchInput | ChoiceInput>} Specs by name
 * @typedef {Record<string, any>} Inputs values by name, each of the type that its input says
 */

/**
 * A figure that answers the hand.
 * @typedef {object} Spec
 * @property {string} name
 * @property {Specs} inputs
 * @property {Inputs} start
 * @property {string} model
 * @property {Record<string, any>} constants of its model
 * @property {Output[]} outputs
 * @property {Chart[]} charts
 * @property {[string, Inputs][]} tries
 * @property {boolean} [small]
 *
 * @typedef {{name: string, label: string, digits: number, unit: string, loud: string, where: string,
 *   color: string}} Output how it is written
 * @typedef {{name: string, label: string, over: string, x: [number, number], y: [number, number],
 *   colors: Record<string, string>, marks: string[], dashed: string[],
 *   ticks: [number, string][]}} Chart
 * @typedef {number[] | number[][] | null} Curve heights, in one or more pieces, or none for now
 * @typedef {Record<string, Curve>} Curves by name
 */

/**
 * What a model computes from inputs, constants and the names of what has changed.
 * @typedef {object} State
 * @property {Record<string, Change>} parts
 * @property {Record<string, Point | null>} labels
 * @property {Record<string, Grip>} [grips] where inputs can be grabbed
 * @property {Record<string, Sight>} [views] from where other pictures see the scene
 * @property {Record<string, Point | null>} [trails] what draws its way under the hand
 * @property {Inputs} [inputs] corrected ones
 * @property {Record<string, Told>} outputs
 * @property {Record<string, Curves>} [charts]
 *
 * @typedef {(inputs: any, constants: any, changed: string[]) => State} Model
 * @typedef {Record<string, Model>} Models by name
 * @typedef {string | number | number[] | number[][]} Told
 * @typedef {{at?: Point, from?: Point, to?: Point, paths?: Point[][], points?: Point[],
 *   matrix?: number[], count?: number, color?: Point, hidden?: boolean}} Change of one part
 * @typedef {{path?: Point[] | null, body?: Point[], at?: Point | Point[], size?: number,
 *   turn?: number[][], laps?: number, holds?: string[]}} Grip of an input, and the parts that it holds, one for each
 *   point or body
 * @typedef {{eye: Point, target: Point, up: Point, angle: number}} Sight
 */

/**
 * A scene as glTF brings it.
 * @typedef {{position: Point, target: Point, up: Point, viewAngle: number, aspect: number,
 *   swing?: number}} PosterCamera
 * @typedef {{positions: ArrayLike<number>, corners: ArrayLike<number>, around: import("three").Sphere,
 *   seeThrough?: boolean}} Surface that hides labels: points, three of them for each face, and a sphere
 *   around all
 * @typedef {import("three").Mesh<import("three").BufferGeometry, any>} Drawn
 * @typedef {{positions: Float32Array, normals: Float32Array, corners: Uint32Array, size?: string}} Skin
 * @typedef {object} Part
 * @property {Drawn[]} objects what draws it
 * @property {Change} [change] the last one
 * @property {{at?: Point, radius?: number, tip?: number}} place as `rotedu.figures.state` recorded it
 * @property {Surface & {rest: ArrayLike<number>, positions: Float32Array}} [surface]
 * @property {Skin} [skin] its lines or its arrow, if it has been drawn anew
 * @property {Drawn[]} [ground] what draws its shadow
 * @property {boolean} [own] whether its points belong to no other part
 */

export {};
