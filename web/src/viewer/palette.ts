// The colours of things, by theme; the page's own colours are in viewer.css.

export interface Palette {
  background: string;
  front: string;
  back: string;
  given: string;
  givenBack: string;
  edge: string;
  edgeOpacity: number;
  cage: string;
  cageFace: string;
  point: string;
  pointRim: string;
  crease: string;
  boundary: string;
}

export const kLight: Palette = {
  background: '#eef0f3', front: '#e0a63c', back: '#6b86a8', given: '#b9c2cc', givenBack: '#8fa0b5',
  edge: '#27313d', edgeOpacity: 0.55, cage: '#3d4f66', cageFace: '#e3e8ee', point: '#b3213a', pointRim: '#ffffff',
  crease: '#c2185b', boundary: '#0a7d5a',
};
export const kDark: Palette = {
  background: '#14181d', front: '#e5ae45', back: '#5d7da6', given: '#8d99a6', givenBack: '#5f7189',
  edge: '#e8edf2', edgeOpacity: 0.4, cage: '#9fb6d3', cageFace: '#1e252d', point: '#ff6b7d', pointRim: '#14181d',
  crease: '#ff5c9d', boundary: '#3ddba4',
};
